#include "verifier/probe/half_spaces.h"

#include <array>
#include <cmath>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Vec3;

namespace {

/// The spaces whose boundaries a candidate lies on.
struct TightSpaces {
  std::array<const HalfSpace*, 3> of{};
  int count = 0;
};

/// Gram matrix of the normals, right side: how far p is from each boundary.
struct GramSystem {
  std::array<Vec3, 3> rows;
  Vec3 right;
};

GramSystem gram_of(const TightSpaces& tight, const Vec3& p) {
  GramSystem s;
  for (int i = 0; i < 3; ++i) {
    s.rows[i] = {};
    s.rows[i][i] = 1;  // of what is not there: a multiplier of zero
    if (i >= tight.count) continue;
    for (int j = 0; j < tight.count; ++j)
      s.rows[i][j] = dot(tight.of[i]->normal, tight.of[j]->normal);
    s.right[i] = tight.of[i]->offset_mm - dot(tight.of[i]->normal, p);
  }
  return s;
}

/// The multipliers by Cramer's rule; nothing where two boundaries are nearly parallel.
std::optional<Vec3> multipliers(const GramSystem& s) {
  const Vec3 c = cross(s.rows[1], s.rows[2]);
  const double determinant = dot(s.rows[0], c);
  if (!(determinant > kSingular)) return std::nullopt;
  // The matrix is symmetric: its rows are its columns.
  const Vec3 x = c * s.right.x + cross(s.rows[2], s.rows[0]) * s.right.y +
                 cross(s.rows[0], s.rows[1]) * s.right.z;
  return x / determinant;
}

/// The nearest point on the boundaries, where it is the nearest of the spaces' common part.
std::optional<Vec3> candidate(const TightSpaces& tight, std::span<const HalfSpace> all,
                              const Vec3& p) {
  const std::optional<Vec3> by = multipliers(gram_of(tight, p));
  if (!by) return std::nullopt;
  Vec3 q = p;
  for (int i = 0; i < tight.count; ++i) {
    if ((*by)[i] < 0) return std::nullopt;
    q += tight.of[i]->normal * (*by)[i];
  }
  for (const HalfSpace& space : all)
    if (dot(space.normal, q) < space.offset_mm - kDistanceRounding_mm / 2) return std::nullopt;
  return q;
}

}  // namespace

std::optional<Vec3> nearest_in_all(std::span<const HalfSpace> spaces, const Vec3& p) {
  // The optimum is the one point with multipliers that are not negative: the first found is it.
  if (const auto q = candidate({}, spaces, p)) return q;
  const std::size_t n = spaces.size();
  for (std::size_t i = 0; i < n; ++i)
    if (const auto q = candidate({{&spaces[i]}, 1}, spaces, p)) return q;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (const auto q = candidate({{&spaces[i], &spaces[j]}, 2}, spaces, p)) return q;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        if (const auto q = candidate({{&spaces[i], &spaces[j], &spaces[k]}, 3}, spaces, p))
          return q;
  return std::nullopt;
}

}  // namespace limitgauge::verifier
