#include "engine/surface/chord_bound.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitgauge::engine::surface {
namespace {

/// Heights of 4×4 points over a plane and which of them exist.
struct Stencil {
  std::array<double, 16> height{};
  std::array<bool, 16> known{};

  bool has(int u, int v) const { return known[v * 4 + u]; }
  double operator()(int u, int v) const { return height[v * 4 + u]; }
};

/// Largest second difference of three points in a row, over the rows that exist.
double straight(const Stencil& s, int du, int dv) {
  double largest = 0;
  for (int v = dv; v < 4 - dv; ++v)
    for (int u = du; u < 4 - du; ++u) {
      if (!s.has(u, v) || !s.has(u + du, v + dv) || !s.has(u - du, v - dv)) continue;
      largest = std::max(largest, std::abs(s(u + du, v + dv) - 2 * s(u, v) + s(u - du, v - dv)));
    }
  return largest;
}

double mixed(const Stencil& s) {
  double largest = 0;
  for (int v = 0; v < 3; ++v)
    for (int u = 0; u < 3; ++u) {
      if (!s.has(u, v) || !s.has(u + 1, v) || !s.has(u, v + 1) || !s.has(u + 1, v + 1)) continue;
      largest = std::max(largest, std::abs(s(u, v) + s(u + 1, v + 1) - s(u + 1, v) - s(u, v + 1)));
    }
  return largest;
}

double interpolation_bound(const Stencil& s) {
  return (straight(s, 1, 0) + 2 * mixed(s) + straight(s, 0, 1)) / 8;
}

Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  return normalized(cross(b - a, c - a));
}

/// Points of a grid around cell (u, v): `point(u, v)` where `known(u, v)`.
template <class Point, class Known>
Stencil stencil(int u, int v, const Vec3& normal, const Point& point, const Known& known) {
  Stencil s;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int pu = u - 1 + i, pv = v - 1 + j;
      if (!known(pu, pv)) continue;
      s.known[j * 4 + i] = true;
      s.height[j * 4 + i] = dot(normal, point(pu, pv));
    }
  return s;
}

/// Control points that shape cells beside a side: none across a boundary or crease, where the
/// surface is its own reflection.
class ControlKnown {
 public:
  explicit ControlKnown(const CellPatch& patch) : m_(patch.cells()) {
    for (int c = 0; c < 4; ++c) across_[c] = patch.has_border(c) && !patch.sharp_side(c);
  }
  bool operator()(int u, int v) const {
    const bool outside_u = u < 0 || u > m_, outside_v = v < 0 || v > m_;
    if (outside_u && outside_v) return false;
    return !(v < 0 && !across_[0]) && !(u > m_ && !across_[1]) && !(v > m_ && !across_[2]) &&
           !(u < 0 && !across_[3]);
  }

 private:
  int m_;
  std::array<bool, 4> across_{};
};

struct CellBounds {
  const CellPatch& patch;
  const LimitPatch& limit;
  double offset_mm;
  ControlKnown control_known;
  int m;

  // Why these margins: second differences of samples average the second derivative over two
  // cells, so its peak inside the cell may be larger; at an extraordinary corner it may grow
  // geometrically towards the corner.
  static constexpr double kExtraordinaryMargin = 2.0;
  static constexpr double kSampleMargin = 1.5;

  bool at_corner(int u, int v) const { return (u == 0 || u == m - 1) && (v == 0 || v == m - 1); }
  double& offset_bound_at(int u, int v, ChordBound& bound) const {
    const int low = m / 4, high = m - m / 4;
    if (v < low && u < low) return bound.corner_offset_mm[0];
    if (v < low && u >= high) return bound.corner_offset_mm[1];
    if (v >= high && u >= high) return bound.corner_offset_mm[2];
    if (v >= high && u < low) return bound.corner_offset_mm[3];
    return bound.offset_mm;
  }
  Vec3 sample(int u, int v, double by) const {
    const int i = limit.index(u, v);
    return limit.points[i] + limit.normals[i] * by;
  }
  double sampled(int u, int v, double by, bool upper) const {
    const Vec3 a = sample(u, v, by), b = sample(u + 1, v + 1, by);
    const Vec3 n =
        upper ? unit_normal(a, b, sample(u, v + 1, by)) : unit_normal(a, sample(u + 1, v, by), b);
    const auto inside = [this](int pu, int pv) { return pu >= 0 && pv >= 0 && pu <= m && pv <= m; };
    return interpolation_bound(stencil(
        u, v, n, [&](int pu, int pv) { return sample(pu, pv, by); }, inside));
  }
  double controlled(int u, int v, bool upper) const {
    const Vec3 a = sample(u, v, 0), b = sample(u + 1, v + 1, 0);
    const Vec3 n =
        upper ? unit_normal(a, b, sample(u, v + 1, 0)) : unit_normal(a, sample(u + 1, v, 0), b);
    return interpolation_bound(stencil(
        u, v, n, [this](int pu, int pv) { return patch.control(pu, pv); }, control_known));
  }
};

/// Of the curve along a side, from the second differences of its points.
double outline_bound(const LimitPatch& limit, int side) {
  const int m = limit.cells();
  double largest = 0;
  for (int t = 1; t < m; ++t) {
    const Vec3 a = limit.points[limit.side_index(side, t - 1)];
    const Vec3 b = limit.points[limit.side_index(side, t)];
    const Vec3 c = limit.points[limit.side_index(side, t + 1)];
    largest = std::max(largest, length(a - b * 2.0 + c));
  }
  return CellBounds::kSampleMargin * largest / 8;
}

}  // namespace

ChordBound chord_bound(const CellPatch& patch, const LimitPatch& limit, double offset_mm,
                       const std::array<bool, 4>& rim) {
  const CellBounds cell{patch, limit, offset_mm, ControlKnown(patch), patch.cells()};
  ChordBound bound;
  for (int side = 0; side < 4; ++side)
    if (rim[side]) bound.limit_mm = std::max(bound.limit_mm, outline_bound(limit, side));
  for (int v = 0; v < cell.m; ++v)
    for (int u = 0; u < cell.m; ++u)
      for (const bool upper : {false, true}) {
        double here = cell.controlled(u, v, upper);
        if (cell.at_corner(u, v))
          here = std::max(here, CellBounds::kExtraordinaryMargin * cell.sampled(u, v, 0, upper));
        bound.limit_mm = std::max(bound.limit_mm, here);
        double& offset = cell.offset_bound_at(u, v, bound);
        offset = std::max(offset, here);
        if (offset_mm > 0)
          offset =
              std::max(offset, CellBounds::kSampleMargin * cell.sampled(u, v, offset_mm, upper));
      }
  return bound;
}

}  // namespace limitgauge::engine::surface
