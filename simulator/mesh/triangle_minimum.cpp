#include "simulator/mesh/triangle_minimum.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

// (5/9)^150 of a metre's square is below what doubles tell apart.
constexpr int kMostCuts = 150;

// In the triangle's own coordinates: a + u (b − a) + v (c − a).
struct Place2 {
  double u = 0, v = 0;
};
using Polygon = std::vector<Place2>;

Place2 centre_of_gravity(const Polygon& p) {
  double area = 0;
  Place2 sum, mean;
  const double share = 1 / static_cast<double>(p.size());
  for (const Place2& q : p) mean.u += q.u * share, mean.v += q.v * share;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Place2 &a = p[i], &b = p[(i + 1) % p.size()];
    const double twice = (a.u - mean.u) * (b.v - mean.v) - (b.u - mean.u) * (a.v - mean.v);
    area += twice;
    sum.u += twice * (a.u + b.u - 2 * mean.u) / 3;
    sum.v += twice * (a.v + b.v - 2 * mean.v) / 3;
  }
  // A polygon without area, by rounding, is a line about its mean.
  if (!(area > 0)) return mean;
  return {mean.u + sum.u / area, mean.v + sum.v / area};
}

// The part of a polygon where h <= 0; h is linear.
template <class Height>
void cut(Polygon& polygon, Polygon& left, const Height& h) {
  left.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double ha = h(a), hb = h(b);
    if (ha <= 0) left.push_back(a);
    if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) {
      const double t = ha / (ha - hb);
      left.push_back({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
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
    const Place2 c = centre_of_gravity(polygon);
    const Vec3 p = triangle[0] + u * c.u + v * c.v;
    const SweptSample s = swept_distance(body, move, p);
    if (s.distance < bound) {
      best = SurfacePlace{p, s.distance};
      bound = s.distance;
    }
    const double excess = s.distance - (bound - precision_mm);
    const double slope_u = dot(s.gradient, u), slope_v = dot(s.gradient, v);
    cut(polygon, left,
        [&](const Place2& q) { return excess + slope_u * (q.u - c.u) + slope_v * (q.v - c.v); });
  }
  return best;
}

}  // namespace limitgauge::simulator
