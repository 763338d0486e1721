#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/gcode/program.h"
#include "model/geometry/vec2.h"

namespace limitgauge::model {

/// An arc that stands for moves of a path: from where the first of them begins to where the last
/// one ends.
struct FittedArc {
  std::size_t moves = 0;  ///< how many it stands for
  ArcPlane plane = ArcPlane::xy;
  bool counter_clockwise = false;
  Vec2 offset;  ///< centre from start in the plane's axes, as it will be read
};

/// Largest radius of a fitted arc: beyond, the arc bends less than a control's arithmetic shows.
inline constexpr double kLargestArcRadiusMm = 1000;

/// Finds runs of feed moves that an arc may stand for. The path's points must be rounded already;
/// the arc goes through them as they are.
///
/// A run has at least three moves of one feed rate in one plane parallel to XY, ZX or YZ. Its arc
/// turns by half a turn at most, has a radius of 0.01 to 1000 mm, and its two radii, which differ
/// by the rounding of the centre, do so by 0.005 mm at most: Grbl's rule, and stricter than
/// LinuxCNC's.
///
/// Within tolerance means both ways, and in order along the way: model/gcode/ARCS.md.
class ArcFitter {
 public:
  /// `path` must outlive the fitter. Lengths of centres are rounded to `decimals`.
  ArcFitter(const Toolpath& path, double tolerance_mm, int decimals)
      : path_(path), tolerance_mm_(tolerance_mm), decimals_(decimals) {}

  /// An arc that stands for as many moves from `first` on as were found by doubling and bisection,
  /// or nothing where it cannot stand for three.
  std::optional<FittedArc> from(std::size_t first);

 private:
  std::optional<FittedArc> longest_in(ArcPlane plane, std::size_t first);
  bool alike(std::size_t first, std::size_t move) const;
  std::optional<FittedArc> fit(ArcPlane plane, std::size_t first, std::size_t count);
  void gather(ArcPlane plane, std::size_t first, std::size_t count);
  std::optional<Vec2> centre() const;
  double best_shift(Vec2 along, double half_chord_mm) const;
  std::optional<bool> direction(Vec2 centre) const;
  bool within(Vec2 centre) const;

  const Toolpath& path_;
  double tolerance_mm_;
  int decimals_;
  std::vector<Vec2> points_;  ///< of the run being tried, from its first point
};

}  // namespace limitgauge::model
