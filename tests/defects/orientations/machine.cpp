#include "tests/defects/orientations/machine.h"

#include <cmath>
#include <numbers>

namespace limitgauge::tests::defects {

using model::Pose;
using model::Vec3;

Pose turned_about(const Vec3& axis, double angle_deg, const Vec3& through_mm) {
  const double a = angle_deg * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
  const Vec3 k = normalized(axis);
  const auto turned = [&](const Vec3& v) {
    return v * c + cross(k, v) * s + k * (dot(k, v) * (1 - c));
  };
  const Vec3 x = turned({1, 0, 0}), y = turned({0, 1, 0}), z = turned({0, 0, 1});
  Pose pose;
  pose.rows = {Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}};
  pose.shift_mm = through_mm - pose.direction(through_mm);
  return pose;
}

const char* name(Chain chain) {
  switch (chain) {
    case Chain::table_table:
      return "table-table";
    case Chain::head_table:
      return "head-table";
    case Chain::head_head:
      return "head-head";
  }
  return "";
}

bool Machine::is_head(std::size_t axis) const {
  return chain == Chain::head_head || (chain == Chain::head_table && axis == 0);
}

Pose Machine::table(const Angles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (!is_head(i)) pose = pose * turned_about(axes[i].direction, angles_deg[i], axes[i].point_mm);
  return pose;
}

Pose Machine::head(const Angles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (is_head(i)) pose = pose * turned_about(axes[i].direction, angles_deg[i], axes[i].point_mm);
  return pose;
}

Vec3 Machine::arm_mm(const Angles& angles_deg) const {
  return head(angles_deg).point({0, 0, -length_mm});
}

Pose Machine::upright(const Angles& angles_deg) const {
  Pose turn = head(angles_deg).inverse() * table(angles_deg);
  turn.shift_mm = {};
  return turn;
}

Vec3 Machine::tip_mm(const Vec3& joints_mm, const Angles& angles_deg) const {
  const Vec3 gauge = joints_mm + zero_mm + Vec3{0, 0, length_mm};
  return table(angles_deg).point_back(gauge + arm_mm(angles_deg)) - zero_mm;
}

Vec3 Machine::joints_mm(const Vec3& tip_mm, const Angles& angles_deg) const {
  const Vec3 gauge = table(angles_deg).point(tip_mm + zero_mm) - arm_mm(angles_deg);
  return gauge - zero_mm - Vec3{0, 0, length_mm};
}

}  // namespace limitgauge::tests::defects
