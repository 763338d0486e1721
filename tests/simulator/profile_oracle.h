#pragma once

#include <vector>

#include "engine/model/cutter.h"
#include "engine/model/vec3.h"

namespace limitgauge::simulator::test {

/// The cutter's meridian described a second time, as a chain of segments and one arc, with
/// distances worked out feature by feature: shares nothing with the profile under test.
class ProfileOracle {
 public:
  explicit ProfileOracle(const model::Cutter& cutter);
  double signed_distance(double rho, double z) const;

 private:
  struct Point {
    double rho, z;
  };
  double to_segment(Point a, Point b, double rho, double z) const;
  bool inside(double rho, double z) const;

  double disc_, corner_, angle_, length_, top_;
  Point arc_end_;
};

/// Least signed distance over `steps` + 1 positions and a golden section about the best of them.
double brute_swept_distance(const ProfileOracle& oracle, const model::Vec3& from,
                            const model::Vec3& to, const model::Vec3& p, int steps);

}  // namespace limitgauge::simulator::test
