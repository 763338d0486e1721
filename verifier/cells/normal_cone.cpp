#include "verifier/cells/normal_cone.h"

#include <algorithm>
#include <cmath>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr double kChoose2[] = {1, 2, 1}, kChoose3[] = {1, 3, 3, 1},
                 kChoose5[] = {1, 5, 10, 10, 5, 1};

}  // namespace

Vec3 across(const Vec3& n) {
  return normalized(cross(n, std::abs(n.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
}

std::array<Vec3, 36> normal_coefficients(const Bezier& cell) {
  std::array<Vec3, 36> out{};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 3; ++i) {
      const Vec3 along_u =
          (cell.control(4 * j + i + 1) - cell.control(4 * j + i)) * (kChoose2[i] * kChoose3[j]);
      for (int l = 0; l < 3; ++l)
        for (int k = 0; k < 4; ++k) {
          const Vec3 along_v = cell.control(4 * (l + 1) + k) - cell.control(4 * l + k);
          out[6 * (j + l) + i + k] += cross(along_u, along_v) * (kChoose3[k] * kChoose2[l]);
        }
    }
  for (int n = 0; n < 6; ++n)
    for (int m = 0; m < 6; ++m) out[6 * n + m] = out[6 * n + m] / (kChoose5[m] * kChoose5[n]);
  return out;
}

std::optional<double> normal_spread_rad(const std::array<Vec3, 36>& coefficients,
                                        const Vec3& axis) {
  double cosine = 1;
  for (const Vec3& c : coefficients) {
    const double l = length(c);
    if (!(l > 0)) return std::nullopt;
    cosine = std::min(cosine, dot(c, axis) / l);
  }
  // Every normal is a positive combination of the coefficients; so is it within a convex cone.
  if (cosine <= 0) return std::nullopt;
  return std::acos(std::min(1.0, cosine)) + kArcCosineRounding_rad;
}

}  // namespace limitgauge::verifier
