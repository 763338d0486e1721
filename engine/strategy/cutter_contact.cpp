#include "engine/strategy/cutter_contact.h"

#include <cmath>
#include <utility>

#include "engine/strategy/edge_contact.h"

namespace limitgauge::engine::strategy {
namespace {

/// The plane z + gx x + gy y = c that leans on points given later.
struct Lean {
  double gx = 0, gy = 0, steepness = 0;
  bool upright = false;

  explicit Lean(const Vec3& normal) {
    const double across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    const double up = std::abs(normal.z);
    upright = !(across < kUpright * up);
    if (upright) return;
    gx = normal.x / normal.z;
    gy = normal.y / normal.z;
    steepness = across / up;
  }
  double offset(const Vec3& p) const { return p.z + gx * p.x + gy * p.y; }
  double offset(const Corners& t) const {
    return std::max({offset(t[0]), offset(t[1]), offset(t[2])});
  }
};

/// Coordinates of the XY place `x`, `y` in a facet's sides.
struct Sides {
  double u = 0, v = 0;
};

/// Where the body touches a plane of that lean: uphill from the axis.
Sides contact_in(const CutterShape& shape, const Lean& lean, const Vec3& origin, const Vec3& u,
                 const Vec3& v) {
  double x = -origin.x, y = -origin.y;
  if (lean.steepness > 0) {
    const double share = shape.contact_distance(lean.steepness) / lean.steepness;
    x -= lean.gx * share;
    y -= lean.gy * share;
  }
  const double area = u.x * v.y - u.y * v.x;
  return {(x * v.y - y * v.x) / area, (u.x * y - u.y * x) / area};
}

bool touches_triangle(const CutterShape& shape, const Lean& lean, const Corners& t) {
  const Sides at = contact_in(shape, lean, t[0], t[1] - t[0], t[2] - t[0]);
  return at.u >= 0 && at.v >= 0 && at.u + at.v <= 1;
}

void lift_over_edges(const CutterShape& shape, const Corners& t, GreatestLift& greatest) {
  for (int i = 0; i < 3; ++i) lift_over_edge(shape, t[i], t[(i + 1) % 3], greatest);
}

/// The parallelogram that an edge sweeps.
void lift_over_swept_edge(const CutterShape& shape, const Vec3& from, const Vec3& edge,
                          const Vec3& sweep, GreatestLift& greatest) {
  const Lean lean(cross(edge, sweep));
  if (lean.upright) return;
  const double offset = std::max({lean.offset(from), lean.offset(from + edge),
                                  lean.offset(from + sweep), lean.offset(from + edge + sweep)});
  const double lift = offset + shape.support(lean.steepness);
  if (lift <= greatest.known) return;
  const Sides at = contact_in(shape, lean, from, edge, sweep);
  if (at.u >= 0 && at.u <= 1 && at.v >= 0 && at.v <= 1) greatest.take(lift);
}

void lift_over_sweeps(const CutterShape& shape, const Corners& at_a, const Corners& at_b,
                      GreatestLift& greatest) {
  const Vec3 sweep = at_b[0] - at_a[0];
  for (int i = 0; i < 3; ++i) {
    lift_over_edge(shape, at_a[i], at_b[i], greatest);
    lift_over_swept_edge(shape, at_a[i], at_a[(i + 1) % 3] - at_a[i], sweep, greatest);
  }
}

}  // namespace

void lift_over_triangle(const CutterShape& shape, const Corners& seen, GreatestLift& greatest) {
  const Lean lean(cross(seen[1] - seen[0], seen[2] - seen[0]));
  if (!lean.upright) {
    const double lift = lean.offset(seen) + shape.support(lean.steepness);
    if (lift <= greatest.known) return;
    if (touches_triangle(shape, lean, seen)) return greatest.take(lift);
  }
  lift_over_edges(shape, seen, greatest);
}

void lift_over_prism(const CutterShape& shape, const Corners& seen_from_a,
                     const Corners& seen_from_b, GreatestLift& greatest) {
  const Lean lean(cross(seen_from_a[1] - seen_from_a[0], seen_from_a[2] - seen_from_a[0]));
  const Corners* higher = &seen_from_a;
  const Corners* lower = &seen_from_b;
  if (!lean.upright) {
    if (lean.offset(*higher) < lean.offset(*lower)) std::swap(higher, lower);
    const double support = shape.support(lean.steepness);
    const double lift = lean.offset(*higher) + support;
    if (lift <= greatest.known) return;
    if (touches_triangle(shape, lean, *higher)) return greatest.take(lift);
    if (touches_triangle(shape, lean, *lower)) greatest.take(lean.offset(*lower) + support);
  }
  lift_over_edges(shape, *higher, greatest);
  lift_over_edges(shape, *lower, greatest);
  lift_over_sweeps(shape, seen_from_a, seen_from_b, greatest);
}

}  // namespace limitgauge::engine::strategy
