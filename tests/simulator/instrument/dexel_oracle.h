#pragma once

#include "model/geometry/vec3.h"
#include "model/part/cutter.h"

namespace limitgauge::simulator::test {

/// A cutter's flutes described once more, for the test of dexels: the points within the corner
/// radius of a wedge, below the top. The wedge is bounded by parallels to bottom and side.
class DexelOracle {
 public:
  explicit DexelOracle(const model::Cutter& cutter);
  /// Negative inside, zero on the outline, positive outside; convex, and no larger than the
  /// distance.
  double value(double rho, double z) const;
  /// Least value over all places along the move: in convex functions by golden section.
  double swept(const model::Vec3& from, const model::Vec3& to, const model::Vec3& p) const;
  double largest_radius() const { return widest_; }

 private:
  struct Point {
    double rho, z;
  };
  double over_bottom(const Point& p) const;
  double inside_side(const Point& p) const;
  double to_wedge(const Point& p) const;

  Point vertex_{0, 0};
  double corner_ = 0, length_ = 0, bottom_ = 0, lean_ = 0, widest_ = 0;
};

}  // namespace limitgauge::simulator::test
