#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "verifier/cells/surface_cells.h"

namespace limitgauge::verifier {

/// Parts of the cells that a surface is held in, halved when they are first asked for and kept: a
/// search over neighbouring cells holds each against the same parts of S. For one thread.
class CellHalves {
 public:
  struct Halves;
  struct Part {
    explicit Part(const SurfaceCell& of);

    const SurfaceCell* cell = nullptr;
    model::Vec3 middle;
    double radius_mm = 0;  ///< of the control points round the middle
    std::unique_ptr<Halves> halves;
  };
  struct Halves {
    std::array<SurfaceCell, 2> cells;
    std::array<Part, 2> parts;
  };

  explicit CellHalves(const SurfaceCells& cells) : cells_(cells) {}

  Part& whole(std::uint32_t index);
  /// The halves of its longer way.
  static std::array<Part, 2>& halves_of(Part& part);

 private:
  const SurfaceCells& cells_;
  std::unordered_map<std::uint32_t, Part> wholes_;
};

}  // namespace limitgauge::verifier
