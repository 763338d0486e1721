#include <algorithm>
#include <cmath>
#include <span>

#include "verifier/reachability.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

struct Cone {
  Vec3 axis;
  double cosine = 1;
};

std::optional<Cone> cone_of(std::span<const Vec3> directions) {
  Vec3 sum;
  for (const Vec3& d : directions) sum += normalized(d);
  Cone cone{normalized(sum), 1};
  for (const Vec3& d : directions) {
    const double l = length(d);
    if (!(l > 0)) return std::nullopt;
    cone.cosine = std::min(cone.cosine, dot(d, cone.axis) / l);
  }
  return cone.cosine > 0 ? std::optional(cone) : std::nullopt;
}

}  // namespace

std::optional<NormalCone> normal_cone(const Bezier& cell) {
  std::array<Vec3, 12> along_u, along_v;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 3; ++i) {
      along_u[3 * j + i] = cell.control(4 * j + i + 1) - cell.control(4 * j + i);
      along_v[3 * j + i] = cell.control(4 * (i + 1) + j) - cell.control(4 * i + j);
    }
  const auto u = cone_of(along_u), v = cone_of(along_v);
  if (!u || !v) return std::nullopt;
  const Vec3 normal = cross(u->axis, v->axis);
  const double sine = length(normal), cosine = std::abs(dot(u->axis, v->axis));
  const double su2 = 1 - u->cosine * u->cosine, sv2 = 1 - v->cosine * v->cosine;
  const double su = std::sqrt(std::max(0.0, su2)), sv = std::sqrt(std::max(0.0, sv2));
  const double bound = std::sqrt(su * su + 2 * su * sv * cosine + sv * sv);
  // The two cones must not meet, or the cross product may vanish or turn over.
  if (std::asin(su) + std::asin(sv) >= std::asin(std::min(1.0, sine)) || bound >= sine)
    return std::nullopt;
  return NormalCone{normal / sine, std::asin(bound / sine)};
}

}  // namespace limitgauge::verifier
