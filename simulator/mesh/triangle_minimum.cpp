#include "simulator/mesh/triangle_minimum.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "model/geometry/vec2.h"

namespace limitgauge::simulator {
namespace {

using model::Vec2;
using model::Vec3;

// (5/9)^150 of a metre's square is below what doubles tell apart.
constexpr int kMostCuts = 150;

// In the triangle's own coordinates: a + x (b − a) + y (c − a).
using Polygon = std::vector<Vec2>;

Vec2 centre_of_gravity(const Polygon& p) {
  double area = 0;
  Vec2 sum, mean;
  const double share = 1 / static_cast<double>(p.size());
  for (const Vec2& q : p) mean.x += q.x * share, mean.y += q.y * share;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    const double twice = (a.x - mean.x) * (b.y - mean.y) - (b.x - mean.x) * (a.y - mean.y);
    area += twice;
    sum.x += twice * (a.x + b.x - 2 * mean.x) / 3;
    sum.y += twice * (a.y + b.y - 2 * mean.y) / 3;
  }
  // A polygon without area, by rounding, is a line about its mean.
  if (!(area > 0)) return mean;
  return {mean.x + sum.x / area, mean.y + sum.y / area};
}

// The part of a polygon where h <= 0; h is linear.
template <class Height>
void cut(Polygon& polygon, Polygon& left, const Height& h) {
  left.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double ha = h(a), hb = h(b);
    if (ha <= 0) left.push_back(a);
    if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) {
      const double t = ha / (ha - hb);
      left.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  polygon.swap(left);
}

}  // namespace

std::optional<SurfacePlace> least_on_triangle(const CutterProfile& body, const SweptMove& move,
                                              const TriangleCorners& triangle, double bound,
                                              double precision_mm) {
  const Vec3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
  std::optional<SurfacePlace> best;
  Polygon polygon{{0, 0}, {1, 0}, {0, 1}}, left;
  for (int step = 0; step < kMostCuts && !polygon.empty(); ++step) {
    const Vec2 c = centre_of_gravity(polygon);
    const Vec3 p = triangle[0] + u * c.x + v * c.y;
    const SweptSample s = swept_distance(body, move, p);
    if (s.distance < bound) {
      best = SurfacePlace{p, s.distance};
      bound = s.distance;
    }
    const double excess = s.distance - (bound - precision_mm);
    const double slope_u = dot(s.gradient, u), slope_v = dot(s.gradient, v);
    cut(polygon, left,
        [&](const Vec2& q) { return excess + slope_u * (q.x - c.x) + slope_v * (q.y - c.y); });
  }
  return best;
}

}  // namespace limitgauge::simulator
