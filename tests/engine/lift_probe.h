#pragma once
// Independent evaluators of cutter locations: by the definition, from distances to the cutter.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "engine/surface/section/section_chain.h"
#include "model/part/cutter.h"

namespace limitgauge::test {

using engine::surface::Grid;
using model::Vec3;
using Triangle = std::array<Vec3, 3>;

inline constexpr double kNone = -std::numeric_limits<double>::infinity();

/// Distance in the half plane from (d, z) to the outline of the fluted part, which goes straight up
/// from the end of the flutes; negative inside. The outline is followed point by point: the arc of
/// the corner as 720 chords would be too coarse, so arcs are taken as arcs.
inline double open_distance(const model::Cutter& cutter, double d, double z) {
  const double R = cutter.radius_mm(), L = cutter.flute_length_mm;
  const double r = cutter.type == model::CutterType::ball   ? R
                   : cutter.type == model::CutterType::flat ? 0.0
                                                            : cutter.corner_radius_mm;
  const double angle = cutter.taper_angle_deg * std::numbers::pi / 180;
  const double turn = std::numbers::pi / 2 - angle;  // of the corner, from straight down
  const double px = R - r + r * std::sin(turn), pz = r - r * std::cos(turn);
  const bool taper = cutter.type == model::CutterType::taper;
  const double qx = taper ? px + (L - pz) * std::tan(angle) : px, qz = taper ? L : pz;
  const auto to_segment = [&](double ax, double az, double bx, double bz) {
    const double l2 = (bx - ax) * (bx - ax) + (bz - az) * (bz - az);
    const double t =
        l2 > 0 ? std::clamp(((d - ax) * (bx - ax) + (z - az) * (bz - az)) / l2, 0.0, 1.0) : 0.0;
    return std::hypot(d - ax - t * (bx - ax), z - az - t * (bz - az));
  };
  double nearest = std::min(
      {to_segment(0, 0, R - r, 0), to_segment(px, pz, qx, qz), to_segment(qx, qz, qx, qz + 1000)});
  const double phi = std::clamp(std::atan2(d - (R - r), r - z), 0.0, turn);
  nearest =
      std::min(nearest, std::hypot(d - (R - r) - r * std::sin(phi), z - r + r * std::cos(phi)));
  // Inside: above the lower side at that distance.
  double low = 0;
  if (d > qx) return nearest;
  if (d > px && taper)
    low = pz + (d - px) / std::tan(angle);
  else if (d > R - r)
    low = r - std::sqrt(std::max(0.0, r * r - (d - R + r) * (d - R + r)));
  return z > low ? -nearest : nearest;
}

/// Least height of the tip at which a point `d` from the axis, at height 0, keeps `allowance` from
/// the fluted part: by bisection of the distance, which falls as the tip comes down.
inline double point_height(const model::Cutter& cutter, double allowance, double d) {
  if (d > model::largest_radius_mm(cutter) + allowance) return kNone;
  double low = -cutter.flute_length_mm - allowance - 1, high = allowance + 1;
  for (int i = 0; i < 60; ++i) {
    const double z = (low + high) / 2;
    (open_distance(cutter, d, -z) < allowance ? low : high) = z;
  }
  return high;
}

/// The greatest of a concave function over [0, 1] x [0, 1] by ever finer looks around the best
/// place so far.
template <class Function>
double greatest_of(const Function& f) {
  constexpr int kLooks = 34, kSide = 4;
  constexpr double kShrink = 0.5;
  double s = 0.5, t = 0.5, half = 0.5, best = kNone;
  for (int look = 0; look < kLooks; ++look, half *= kShrink) {
    const double s0 = s, t0 = t;
    for (int i = -kSide; i <= kSide; ++i)
      for (int j = -kSide; j <= kSide; ++j) {
        const double a = std::clamp(s0 + half * i / kSide, 0.0, 1.0);
        const double b = std::clamp(t0 + half * j / kSide, 0.0, 1.0);
        if (const double v = f(a, b); v > best) best = v, s = a, t = b;
      }
  }
  return best;
}

/// The same over [0, 1]; the first look is fine, since the function may be nothing but for a part.
template <class Function>
double greatest_along(const Function& f) {
  constexpr int kLooks = 18, kSide = 100, kLater = 10;
  double best = kNone, at = 0.5, half = 0.5;
  for (int look = 0; look < kLooks; ++look) {
    const int side = look == 0 ? kSide : kLater;
    const double middle = at;
    for (int i = -side; i <= side; ++i) {
      const double t = std::clamp(middle + half * i / side, 0.0, 1.0);
      if (const double v = f(t); v > best) best = v, at = t;
    }
    half *= look == 0 ? 0.02 : 0.25;
  }
  return best;
}

/// Lowest tip height over (x, y) for triangles, by the definition at points of them.
inline double brute_height(const model::Cutter& cutter, double allowance,
                           const std::vector<Triangle>& triangles, double x, double y) {
  const double reach = model::largest_radius_mm(cutter) + allowance;
  double best = kNone;
  for (const Triangle& c : triangles) {
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3;
    double size = 0, top = kNone;
    for (const Vec3& p : c) size = std::max(size, distance(p, middle)), top = std::max(top, p.z);
    if (std::hypot(middle.x - x, middle.y - y) > reach + size || top + allowance < best) continue;
    best = std::max(best, greatest_of([&](double s, double t) {
                      const Vec3 q = lerp(c[0], lerp(c[1], c[2], t), s);
                      return q.z + point_height(cutter, allowance, std::hypot(q.x - x, q.y - y));
                    }));
  }
  return best;
}

inline std::vector<Triangle> triangles_of(const std::vector<Grid>& grids) {
  std::vector<Triangle> all;
  for (const Grid& g : grids)
    for (int v = 0; v + 1 < g.rows; ++v)
      for (int u = 0; u + 1 < g.columns; ++u) {
        all.push_back({g.at(u, v), g.at(u + 1, v), g.at(u + 1, v + 1)});
        all.push_back({g.at(u, v), g.at(u + 1, v + 1), g.at(u, v + 1)});
      }
  return all;
}

/// columns x rows points, `point(u, v)`.
inline Grid grid_of(int columns, int rows, const std::function<Vec3(int, int)>& point) {
  Grid grid{columns, rows, {}};
  for (int v = 0; v < rows; ++v)
    for (int u = 0; u < columns; ++u) grid.points.push_back(point(u, v));
  return grid;
}

/// z = height(x, y) over the square of side 2 `half` about the origin.
inline Grid height_grid(int cells, double half,
                        const std::function<double(double, double)>& height) {
  return grid_of(cells + 1, cells + 1, [&](int u, int v) {
    const double x = half * (2.0 * u / cells - 1), y = half * (2.0 * v / cells - 1);
    return Vec3{x, y, height(x, y)};
  });
}

/// Points scattered in all directions, so that cells lean over, stand upright and fold.
inline Grid crumpled_grid(int cells, double half, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-0.6, 0.6), up(-1.5, 1.5);
  const double side = 2 * half / cells;
  return grid_of(cells + 1, cells + 1, [&](int u, int v) {
    const double x = by(random), y = by(random);
    return Vec3{side * (u + x) - half, side * (v + y) - half, side * up(random)};
  });
}

}  // namespace limitgauge::test
