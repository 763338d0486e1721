#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "verifier/cells/surface_cells.h"

namespace limitgauge::verifier {

/// Parts of the cells that a surface is held in, halved when they are first asked for and kept: a
/// search over neighbouring cells holds each against the same parts of S. For one thread.
class CellHalves {
 public:
  struct Halves;
  struct Part {
    Part() = default;
    explicit Part(const SurfaceCell& of);

    const SurfaceCell* cell = nullptr;
    model::Vec3 middle;
    double radius_mm = 0;  ///< of the control points round the middle
    Halves* halves = nullptr;
    bool second_first = false;  ///< in which order to ask of its halves
  };
  struct Halves {
    std::array<SurfaceCell, 2> cells;
    std::array<Part, 2> parts;
  };

  explicit CellHalves(const SurfaceCells& cells);

  /// Good until the next cell is asked for that was not before.
  Part& whole(std::uint32_t index);
  /// The halves of its longer way.
  std::array<Part, 2>& halves_of(Part& part);
  /// Lets go of all parts, but not of their memory, which is good for as many: what is asked of
  /// thousands of parts has their pages only once.
  void forget();

 private:
  /// Pairs of halves that are allocated at once.
  static constexpr std::size_t kBlock = 32;
  static constexpr std::uint32_t kNone = 0xffffffffU;

  const SurfaceCells& cells_;
  std::vector<std::uint32_t> place_;  ///< by cell, in wholes_
  std::vector<std::uint32_t> known_;  ///< cells that have one
  std::vector<Part> wholes_;
  std::vector<std::unique_ptr<Halves[]>> blocks_;
  std::size_t used_ = 0;  ///< pairs, of all blocks
};

}  // namespace limitgauge::verifier
