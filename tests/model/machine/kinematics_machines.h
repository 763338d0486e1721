#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "model/machine/kinematics.h"

/// Machines to test with, and their kinematics worked out a second time: matrices of 4 by 4,
/// written out here, which share nothing with model::Pose.
namespace limitgauge::model::test {

using Matrix = std::array<std::array<double, 4>, 4>;

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// Of a point where `w` is 1, of a direction where it is 0.
inline Vec3 applied(const Matrix& m, const Vec3& v, double w) {
  const auto row = [&](int i) {
    return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z + m[i][3] * w;
  };
  return {row(0), row(1), row(2)};
}

/// The right-handed turn about a line, by Rodrigues' formula.
inline Matrix turn_matrix(const Vec3& direction, const Vec3& through, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const double u[3] = {direction.x, direction.y, direction.z};
  const double across[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
  Matrix m{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m[i][j] = (i == j ? c : 0) + s * across[i][j] + (1 - c) * u[i] * u[j];
  m[3][3] = 1;
  const Vec3 moved = applied(m, through, 0);
  m[0][3] = through.x - moved.x, m[1][3] = through.y - moved.y, m[2][3] = through.z - moved.z;
  return m;
}

inline Matrix axis_matrix(const RotaryAxis& axis, double sign, const RotaryAngles& angles_deg) {
  return turn_matrix(axis.direction, axis.point_mm, sign * angles_deg[axis.index()]);
}

/// The turn of the tables back, first the one that carries the other, and that of the heads.
inline std::pair<Matrix, Matrix> table_back_and_head(const Kinematics& machine,
                                                     const RotaryAngles& angles_deg) {
  Matrix back = turn_matrix({0, 0, 1}, {}, 0), head = back;
  for (std::size_t i = 0; i < machine.axes.size(); ++i)
    if (machine.is_head(i))
      head = product(head, axis_matrix(machine.axes[i], 1, angles_deg));
    else
      back = product(axis_matrix(machine.axes[i], -1, angles_deg), back);
  return {back, head};
}

inline ToolStand stand_by_matrices(const Kinematics& machine, const Vec3& gauge_mm,
                                   const RotaryAngles& angles_deg, double tool_length_mm) {
  const auto [back, head] = table_back_and_head(machine, angles_deg);
  const Vec3 tip = gauge_mm + applied(head, {0, 0, -tool_length_mm}, 1);
  return {applied(back, tip, 1), applied(back, applied(head, {0, 0, 1}, 0), 0)};
}

inline Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<> part;
  return normalized({part(random), part(random), part(random)});
}

inline Vec3 random_place(std::mt19937_64& random, double reach_mm) {
  std::uniform_real_distribution<> at(-reach_mm, reach_mm);
  return {at(random), at(random), at(random)};
}

inline RotaryAngles random_angles(std::mt19937_64& random, double reach_deg) {
  std::uniform_real_distribution<> at(-reach_deg, reach_deg);
  return {at(random), at(random), at(random)};
}

inline bool one_in(std::mt19937_64& random, unsigned n) {
  return random() % n == 0;
}

/// Of one axis or two, along those of the machine's frame or, where `leaning`, along any.
inline Kinematics random_machine(std::mt19937_64& random, bool leaning, std::size_t axes) {
  Kinematics machine;
  machine.kind = static_cast<MachineKind>(random() % 3);
  const int first = static_cast<int>(random() % 3), other = 1 + static_cast<int>(random() % 2);
  for (std::size_t i = 0; i < axes; ++i) {
    const int k = (first + static_cast<int>(i) * other) % 3;
    RotaryAxis axis{static_cast<char>('A' + k), {0, 0, 0}, random_place(random, 300)};
    axis.direction[k] = one_in(random, 2) ? 1 : -1;
    if (leaning) axis.direction = random_direction(random);
    machine.axes.push_back(axis);
  }
  return machine;
}

inline Kinematics random_machine(std::mt19937_64& random) {
  return random_machine(random, one_in(random, 2), 1 + random() % 2);
}

}  // namespace limitgauge::model::test
