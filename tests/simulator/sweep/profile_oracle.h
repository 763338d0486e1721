#pragma once

#include <random>
#include <vector>

#include "model/geometry/vec3.h"
#include "model/part/cutter.h"

namespace limitgauge::simulator::test {

/// The cutter's meridian described a second time, as a chain of segments and one arc, with
/// distances worked out feature by feature: shares nothing with the profile under test, nor with
/// the model's seven figures.
class ProfileOracle {
 public:
  struct Point {
    double rho, z;
  };

  explicit ProfileOracle(const model::Cutter& cutter);
  double signed_distance(double rho, double z) const;
  /// Whether a point is inside, by the outline's heights alone: no distance takes part.
  bool inside(double rho, double z) const;
  /// `count` points along each of bottom, arc, side and top.
  std::vector<Point> outline(int count) const;
  double widest() const;

 private:
  double to_segment(Point a, Point b, double rho, double z) const;

  double corner_, bottom_angle_, side_angle_, length_;
  Point centre_, arc_begin_, arc_end_, rim_;
};

/// Least signed distance over `steps` + 1 positions and a golden section about the best of them.
double brute_swept_distance(const ProfileOracle& oracle, const model::Vec3& from,
                            const model::Vec3& to, const model::Vec3& p, int steps);

/// Which side of the swept space p is on: a position that holds it proves inside; positions whose
/// distance exceeds the way to their neighbours prove outside. `on_surface` where it is nearer than
/// 1e-9 mm to both.
enum class Side { inside, outside, on_surface };
Side proven_side(const ProfileOracle& oracle, const model::Vec3& from, const model::Vec3& to,
                 const model::Vec3& p);

/// Cutters of every type and shape: long, short, pointed, leaning outwards and inwards, with a
/// corner wider than the cutter, closing at the top.
std::vector<model::Cutter> all_cutters();
/// A cutter of any type with random figures; the same for the same state of `random`.
model::Cutter random_cutter(std::mt19937_64& random);

}  // namespace limitgauge::simulator::test
