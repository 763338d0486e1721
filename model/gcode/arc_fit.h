#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/gcode/program.h"

namespace limitgauge::model {

/// An arc that stands for moves of a path: from where the first of them begins to where the last
/// one ends.
struct FittedArc {
  std::size_t moves = 0;  ///< how many it stands for
  ArcPlane plane = ArcPlane::xy;
  bool counter_clockwise = false;
  std::array<double, 2> offset{};  ///< centre from start in the plane's axes, as it will be read
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
/// Within tolerance means both ways. Let c be the centre as it will be read, and r(a) the radius of
/// the arc at angle a about c; a control lets it drift from the radius at the start to that at the
/// end, so min(r0, r1) <= r(a) <= max(r0, r1). The run is accepted only if every one of its moves
/// turns about c in the arc's direction by less than a quarter turn and none of its points lies
/// beyond half a turn: then each angle a of the arc is met by one place p(a) of the run (by
/// several where a move has no length or goes straight from or to c), in the order of the angles.
/// Place and arc at that angle are | |p(a) - c| - r(a) | apart, so that this difference, over all
/// a, bounds the distance of every point of the run from the arc, of every point of the arc from
/// the run, and of the two in their order along the way (Fréchet distance). Over a run, |p - c| is
/// greatest at a point and least at the foot of the perpendicular on a move, or at one of its ends:
/// both are computed, and greatest - min(r0, r1) and max(r0, r1) - least must not exceed the
/// tolerance.
class ArcFitter {
 public:
  /// `path` must outlive the fitter. Lengths of centres are rounded to `decimals`.
  ArcFitter(const Toolpath& path, double tolerance_mm, int decimals)
      : path_(path), tolerance_mm_(tolerance_mm), decimals_(decimals) {}

  /// An arc that stands for as many moves from `first` on as were found by doubling and bisection,
  /// or nothing where it cannot stand for three.
  std::optional<FittedArc> from(std::size_t first);

 private:
  using Point = std::array<double, 2>;

  std::optional<FittedArc> longest_in(ArcPlane plane, std::size_t first);
  bool alike(std::size_t first, std::size_t move) const;
  std::optional<FittedArc> fit(ArcPlane plane, std::size_t first, std::size_t count);
  void gather(ArcPlane plane, std::size_t first, std::size_t count);
  std::optional<Point> centre() const;
  double best_shift(Point along, double half_chord_mm) const;
  std::optional<bool> direction(Point centre) const;
  bool within(Point centre) const;

  const Toolpath& path_;
  double tolerance_mm_;
  int decimals_;
  std::vector<Point> points_;  ///< of the run being tried, from its first point
};

}  // namespace limitgauge::model
