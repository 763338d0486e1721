#include "model/geometry/pose.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "model/base/angle.h"

namespace limitgauge::model {
namespace {

Vec3 absolute(const Vec3& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

Pose pose_of(const Eigen::Matrix3d& m) {
  Pose pose;
  for (int row = 0; row < 3; ++row) pose.rows[row] = {m(row, 0), m(row, 1), m(row, 2)};
  return pose;
}

/// Entries within rounding of a whole number, all of them or none: a quarter of a turn is exact.
Pose exact_where_axes_stay(Pose pose) {
  constexpr double kRounding = 1e-14;
  Pose whole = pose;
  for (Vec3& row : whole.rows)
    for (int k = 0; k < 3; ++k) {
      const double nearest = std::round(row[k]);
      if (std::abs(row[k] - nearest) > kRounding) return pose;
      row[k] = nearest + 0.0;  // no negative zero
    }
  return whole;
}

}  // namespace

Pose Pose::inverse() const {
  Pose back;
  for (int row = 0; row < 3; ++row) back.rows[row] = {rows[0][row], rows[1][row], rows[2][row]};
  back.shift_mm = Vec3{} - back.direction(shift_mm);
  return back;
}

Vec3 Pose::half(const Vec3& half) const {
  return {dot(absolute(rows[0]), half), dot(absolute(rows[1]), half), dot(absolute(rows[2]), half)};
}

Box3 Pose::box(const Box3& box) const {
  if (box.empty()) return box;
  const Vec3 centre = point(box.centre()), h = half(box.size() / 2);
  return {centre - h, centre + h};
}

double Pose::widening() const {
  const Vec3 one = half({1, 1, 1});
  return std::max({one.x, one.y, one.z});
}

bool Pose::keeps_axes() const {
  return std::all_of(rows.begin(), rows.end(), [](const Vec3& row) {
    const Vec3 a = absolute(row);
    return a.x + a.y + a.z == 1 && std::max({a.x, a.y, a.z}) == 1;
  });
}

Pose operator*(const Pose& then, const Pose& first) {
  Pose both;
  const Pose columns = first.inverse();
  for (int row = 0; row < 3; ++row) both.rows[row] = columns.direction(then.rows[row]);
  both.shift_mm = then.point(first.shift_mm);
  return both;
}

Pose turn_about(const Vec3& axis, double angle_deg) {
  const double size = length(axis);
  if (!is_finite(axis) || !(size > 0) || !std::isfinite(size) || !std::isfinite(angle_deg))
    throw std::invalid_argument("a turn needs an axis of some length and a finite angle");
  const Vec3 unit = axis / size;
  const Eigen::AngleAxisd turn(radians(std::remainder(angle_deg, 360.0)),
                               Eigen::Vector3d(unit.x, unit.y, unit.z));
  return exact_where_axes_stay(pose_of(turn.toRotationMatrix()));
}

Turn turn_of(const Pose& pose) {
  if (!pose.turns()) return {{0, 0, 1}, 0};
  Eigen::Matrix3d m;
  for (int row = 0; row < 3; ++row)
    m.row(row) << pose.rows[row].x, pose.rows[row].y, pose.rows[row].z;
  const Eigen::AngleAxisd turn(m);
  return {{turn.axis().x(), turn.axis().y(), turn.axis().z()},
          turn.angle() * 180 / std::numbers::pi};
}

Pose rotation_of(const std::array<Vec3, 3>& rows, double tolerance) {
  Eigen::Matrix3d m;
  for (int row = 0; row < 3; ++row) m.row(row) << rows[row].x, rows[row].y, rows[row].z;
  if (!m.allFinite() ||
      (m * m.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > tolerance)
    throw std::invalid_argument("the rows are no rotation: not of length one, or not square");
  if (m.determinant() < 0) throw std::invalid_argument("the rows mirror the part");
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return exact_where_axes_stay(pose_of(svd.matrixU() * svd.matrixV().transpose()));
}

}  // namespace limitgauge::model
