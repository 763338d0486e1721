#pragma once

#include <cstddef>
#include <vector>

#include "engine/strategy/levels/curve_need.h"
#include "engine/strategy/levels/unsure_nodes.h"
#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/raster/isoline.h"
#include "engine/strategy/raster/tip_raster.h"

namespace limitgauge::engine::strategy {

/// Shares of a waterline's tolerance: how far chords between points of the curve may leave it, and
/// its points the curve.
inline constexpr double kCurveShare = 0.15, kCrossingShare = 0.05;

/// To the left of the way from `a` to `b`: the free side.
inline FlatPoint left_of(const FlatPoint& a, const FlatPoint& b) {
  const double length = distance(a, b);
  if (length <= 0) return {0, 0};
  return {-(b.y - a.y) / length, (b.x - a.x) / length};
}
inline FlatPoint moved(const FlatPoint& p, const FlatPoint& direction, double by) {
  return {p.x + direction.x * by, p.y + direction.y * by};
}

/// The curves on which the tip height passes `height_mm`: what is higher is forbidden. Points lie
/// on the free side, within kCrossingShare of the tolerance of the curve; the forbidden side is on
/// the right.
///
/// A raster says where curves run. Points of them are found exactly a few cells apart, and more
/// where a look at the middles of chords, at most four cells apart, finds the curve beside them.
/// Where the surface is as good as level a curve may wind without end: between two exact points no
/// more than so many chords are looked at, and whoever cuts along the rest has to prove it. Queries
/// count what they look at: one thread an object.
class HeightCurves {
 public:
  /// `need` is wide enough for what the raster does not see, `unsure` the nodes of its cells.
  HeightCurves(const CutterLocations& locations, const TipRaster& tips, const CurveNeed& need,
               const UnsureNodes& unsure, double height_mm, double tolerance_mm)
      : locations_(locations),
        tips_(tips),
        need_(need),
        unsure_(unsure),
        height_(height_mm),
        tolerance_(tolerance_mm),
        field_(sides()) {}

  double height_mm() const { return height_; }
  bool held_at(const FlatPoint& p) const {
    ++looks_;
    return !locations_.clears({p.x, p.y, height_}, {p.x, p.y, height_}, 0);
  }
  /// Of a closed one the first point is repeated at the end.
  std::vector<Isoline> curves() const;
  /// How many places were looked at so far: what curves cost. No more than a few hundred a point of
  /// the raster's lines, whatever the surface is like.
  std::size_t looks() const { return looks_; }

 private:
  /// Tip height at a place less that of the curve; minus infinity where nothing is under the
  /// cutter.
  double above(const FlatPoint& p) const;
  /// 1 at nodes that are forbidden, -1 at free ones.
  std::vector<float> sides() const;
  struct Place {
    FlatPoint at;
    double above_mm = 0;  ///< of the curve
  };
  /// A free and a forbidden place; the curve lies between.
  struct Bracket {
    Place free, held;
    double width() const { return distance(free.at, held.at); }
  };
  /// Of a place that was found `held` or not.
  Place place(const FlatPoint& at, bool held) const;
  Bracket narrowed(Bracket b) const;
  FlatPoint crossing_past(const FlatPoint& from, const FlatPoint& other, bool held) const;
  FlatPoint exact(const FlatPoint& edge_middle) const;
  std::vector<std::size_t> spread_out(const Isoline& line) const;
  std::vector<FlatPoint> exact_points(const Isoline& line) const;
  std::vector<FlatPoint> densified(const std::vector<FlatPoint>& points) const;
  /// `chords_left`: how many more are looked at beside.
  void densify(const FlatPoint& a, const FlatPoint& b, int& chords_left,
               std::vector<FlatPoint>& dense) const;
  void densify_halves(const FlatPoint& a, const FlatPoint& b, int& chords_left,
                      std::vector<FlatPoint>& dense) const;
  bool find_beside(const FlatPoint& a, const FlatPoint& b, FlatPoint& found) const;

  const CutterLocations& locations_;
  const TipRaster& tips_;
  const CurveNeed& need_;
  const UnsureNodes& unsure_;
  double height_, tolerance_;
  mutable std::size_t looks_ = 0;
  std::vector<float> field_;
};

}  // namespace limitgauge::engine::strategy
