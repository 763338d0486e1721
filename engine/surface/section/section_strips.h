#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/surface/section/grid_section.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::surface {

/// A grid that is made when planes meet it and let go of afterwards.
struct SectionPiece {
  std::size_t points = 0;  ///< of the grid
  /// The same grid to the last bit each time, from any thread.
  std::function<Grid()> make;
  /// No point of the grid lies outside [low, high] along the axis: only planes above `low` and up
  /// to `high` meet it. Unmeasured, all planes may.
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

std::size_t points_of(std::span<const SectionPiece> pieces);
/// Sets the range of each piece to that of its points: makes the grids, a few at a time.
void measure_ranges(std::vector<SectionPiece>& pieces, int axis, const model::RunControl& control);

/// The sections of many grids by a family of planes, strip by strip (after the S-Buffer): a strip
/// is a run of consecutive planes, and what is held at a time are the grids that its planes meet.
///
/// The chains of a plane do not depend on strips: a grid that a plane does not meet leaves nothing
/// in it, and where a chain begins in a grid is found for each plane by itself (StartSearch).
class SectionStrips {
 public:
  /// Planes [first, last) of a family, and the points of all grids that they meet.
  struct Strip {
    std::size_t first = 0, last = 0;
    std::size_t points = 0;
  };
  /// The chains of plane number `plane` of a family, piece by piece. Called once a plane, from any
  /// thread; the chains may be taken.
  using Take = std::function<void(std::size_t plane, std::vector<SectionChain>& chains)>;

  /// At most `most_points` are held at a time, or as many as the plane that meets most needs by
  /// itself. Where all pieces are within `most_points` they are made here and stay.
  SectionStrips(std::vector<SectionPiece> pieces, int axis, std::size_t most_points,
                const model::RunControl& control);

  /// How planes at `values` (ascending) are dealt with: as many at a time as the bound allows.
  std::vector<Strip> strips(std::span<const double> values) const;
  /// Sections by the planes at `values` (ascending). Returns the most points held at a time.
  std::size_t trace(std::span<const double> values, const model::RunControl& control,
                    const Take& take) const;

 private:
  /// Grids as far as they are made, a place for each piece.
  using Held = std::vector<std::optional<GridSection>>;
  /// Planes [first, last) of a family, those that meet a piece.
  struct Planes {
    std::size_t first = 0, last = 0;
    bool none() const { return first == last; }
    bool meet(const Strip& strip) const {
      return !none() && first < strip.last && last > strip.first;
    }
  };
  /// By planes, points of the pieces that are met there and not before, and of all met there.
  struct Loads {
    std::vector<std::size_t> begun, met;
  };
  Loads loads(std::span<const double> values) const;
  std::vector<Planes> meeting(std::span<const double> values) const;
  std::vector<std::size_t> pieces_in(const Strip& strip, std::span<const Planes> met) const;
  void make(std::span<const std::size_t> wanted, const model::RunControl& control,
            Held& held) const;

  std::vector<SectionPiece> pieces_;
  int axis_;
  std::size_t most_points_;
  Held kept_;  ///< all pieces or none
};

}  // namespace limitgauge::engine::surface
