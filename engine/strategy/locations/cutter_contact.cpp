#include "engine/strategy/locations/cutter_contact.h"

#include <cmath>

#include "engine/strategy/locations/edge_contact.h"

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

/// Where the body touches a plane of that lean: uphill from the axis.
Vec3 contact_of(const CutterShape& shape, const Lean& lean) {
  if (lean.steepness <= 0) return {};
  const double share = shape.contact_distance(lean.steepness) / lean.steepness;
  return {-lean.gx * share, -lean.gy * share, 0};
}

/// Place of XY point `p` in the sides `u` and `v` from `origin`.
struct Sides {
  double u = 0, v = 0;

  Sides(const Vec3& p, const Vec3& origin, const Vec3& side_u, const Vec3& side_v) {
    const double x = p.x - origin.x, y = p.y - origin.y;
    const double area = side_u.x * side_v.y - side_u.y * side_v.x;
    u = (x * side_v.y - y * side_v.x) / area;
    v = (side_u.x * y - side_u.y * x) / area;
  }
};

void lift_over_edges(const CutterShape& shape, const Corners& t, GreatestLift& greatest) {
  for (int i = 0; i < 3; ++i) lift_over_edge(shape, t[i], t[(i + 1) % 3], greatest);
}

/// The lift falls away from the contact with the whole plane. So the greatest lies there, or on a
/// side of the facet that faces it.
void lift_over_facet(const CutterShape& shape, const Lean& lean, const Corners& t, double lift,
                     GreatestLift& greatest) {
  const Sides at(contact_of(shape, lean), t[0], t[1] - t[0], t[2] - t[0]);
  if (at.u >= 0 && at.v >= 0 && at.u + at.v <= 1) return greatest.take(lift);
  if (!(at.u >= 0)) lift_over_edge(shape, t[0], t[2], greatest);
  if (!(at.v >= 0)) lift_over_edge(shape, t[0], t[1], greatest);
  if (!(at.u + at.v <= 1)) lift_over_edge(shape, t[1], t[2], greatest);
}

/// The four corners of the parallelogram that an edge sweeps, and the corner of the triangle that
/// is not on the edge.
struct SweptEdge {
  Vec3 a0, a1, b0, b1, opposite;
};

void lift_over_outline(const CutterShape& shape, const SweptEdge& e, GreatestLift& greatest) {
  lift_over_edge(shape, e.a0, e.a1, greatest);
  lift_over_edge(shape, e.b0, e.b1, greatest);
  lift_over_edge(shape, e.a0, e.b0, greatest);
  lift_over_edge(shape, e.a1, e.b1, greatest);
}

void lift_over_swept_edge(const CutterShape& shape, const SweptEdge& e, GreatestLift& greatest) {
  const Vec3 edge = e.a1 - e.a0, sweep = e.b0 - e.a0;
  const Lean lean(cross(edge, sweep));
  if (lean.upright) return lift_over_outline(shape, e, greatest);
  const double offset =
      std::max({lean.offset(e.a0), lean.offset(e.a1), lean.offset(e.b0), lean.offset(e.b1)});
  // A lower side of the prism: the upper ones have all that is above it.
  if (lean.offset(e.opposite) > offset) return;
  const double lift = offset + shape.support(lean.steepness);
  if (lift <= greatest.known) return;
  const Sides at(contact_of(shape, lean), e.a0, edge, sweep);
  if (at.u >= 0 && at.u <= 1 && at.v >= 0 && at.v <= 1) return greatest.take(lift);
  if (!(at.u >= 0)) lift_over_edge(shape, e.a0, e.b0, greatest);
  if (!(at.u <= 1)) lift_over_edge(shape, e.a1, e.b1, greatest);
  if (!(at.v >= 0)) lift_over_edge(shape, e.a0, e.a1, greatest);
  if (!(at.v <= 1)) lift_over_edge(shape, e.b0, e.b1, greatest);
}

}  // namespace

void lift_over_triangle(const CutterShape& shape, const Corners& seen, GreatestLift& greatest) {
  const Lean lean(cross(seen[1] - seen[0], seen[2] - seen[0]));
  if (lean.upright) return lift_over_edges(shape, seen, greatest);
  const double lift = lean.offset(seen) + shape.support(lean.steepness);
  if (lift > greatest.known) lift_over_facet(shape, lean, seen, lift, greatest);
}

void lift_over_prism(const CutterShape& shape, const Corners& seen_from_a,
                     const Corners& seen_from_b, GreatestLift& greatest) {
  const Lean lean(cross(seen_from_a[1] - seen_from_a[0], seen_from_a[2] - seen_from_a[0]));
  if (!lean.upright) {
    const double a = lean.offset(seen_from_a), b = lean.offset(seen_from_b);
    const double lift = std::max(a, b) + shape.support(lean.steepness);
    if (lift <= greatest.known) return;
    lift_over_facet(shape, lean, a > b ? seen_from_a : seen_from_b, lift, greatest);
    if (lift <= greatest.known) return;
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    lift_over_swept_edge(
        shape, {seen_from_a[i], seen_from_a[j], seen_from_b[i], seen_from_b[j], seen_from_a[k]},
        greatest);
  }
}

}  // namespace limitgauge::engine::strategy
