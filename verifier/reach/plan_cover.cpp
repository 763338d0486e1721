#include "verifier/reach/plan_cover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace limitgauge::verifier {
namespace {

double outside(const PlanDisc& d, const model::Vec2& p) {
  return (p.x - d.x) * (p.x - d.x) + (p.y - d.y) * (p.y - d.y) - d.radius * d.radius;
}
/// Where the segment from a, inside, to b, outside, leaves the disc; no nearer to b.
model::Vec2 exit_of(const PlanDisc& d, const model::Vec2& a, const model::Vec2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, ax = a.x - d.x, ay = a.y - d.y;
  const double whole = dx * dx + dy * dy, half = ax * dx + ay * dy,
               free = std::max(0.0, half * half - whole * outside(d, a));
  const double t = whole > 0 ? std::clamp((std::sqrt(free) - half) / whole, 0.0, 1.0) : 0;
  return {a.x + t * dx, a.y + t * dy};
}

/// What a disc leaves of a hull lies in the hull of the corners outside it and of where the sides
/// leave it.
PlanHull less(const PlanHull& hull, const PlanDisc& disc) {
  PlanHull out;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const model::Vec2 &a = hull[k], &b = hull[(k + 1) % hull.size()];
    const bool a_inside = outside(disc, a) < 0, b_inside = outside(disc, b) < 0;
    if (!a_inside) out.push_back(a);
    if (a_inside != b_inside) out.push_back(a_inside ? exit_of(disc, a, b) : exit_of(disc, b, a));
  }
  return corners_of(std::move(out));
}

}  // namespace

PlanHull corners_of(PlanHull points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](const model::Vec2& a, const model::Vec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  PlanHull out;
  const auto add_side = [&](auto begin, auto end) {
    const std::size_t first = out.size();
    for (auto p = begin; p != end; ++p) {
      while (out.size() >= first + 2) {
        const model::Vec2 &a = out[out.size() - 2], &b = out.back();
        if ((b.x - a.x) * (p->y - a.y) - (b.y - a.y) * (p->x - a.x) > 0) break;
        out.pop_back();
      }
      out.push_back(*p);
    }
    out.pop_back();
  };
  add_side(points.begin(), points.end());
  add_side(points.rbegin(), points.rend());
  return out;
}

bool covered(PlanHull hull, std::vector<PlanDisc> discs) {
  while (!hull.empty() && !discs.empty()) {
    const auto held = [&](const PlanDisc& disc) {
      return std::count_if(hull.begin(), hull.end(),
                           [&](const model::Vec2& p) { return outside(disc, p) < 0; });
    };
    std::size_t best = 0;
    std::ptrdiff_t most = 0;
    for (std::size_t k = 0; k < discs.size(); ++k)
      if (const auto count = held(discs[k]); count > most) most = count, best = k;
    if (most == 0) return false;
    hull = less(hull, discs[best]);
    discs.erase(discs.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return hull.empty();
}

}  // namespace limitgauge::verifier
