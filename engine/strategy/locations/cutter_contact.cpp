#include "engine/strategy/locations/cutter_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {
namespace {

constexpr int kMostSteps = 80;

/// A segment as seen from the axis: at the place s its distance is hypot(aside, s) and its height
/// top - rise (end - s), with rise >= 0; s runs over [begin, end].
struct Slant {
  double aside = 0, begin = 0, end = 0, rise = 0, top = 0;

  Slant(const Vec3& from, const Vec3& to, double length) {
    const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
    aside = std::abs(dx * from.y - dy * from.x);
    begin = from.x * dx + from.y * dy;
    end = to.x * dx + to.y * dy;
    rise = (to.z - from.z) / length;
    top = to.z;
    if (rise < 0) {
      begin = std::exchange(end, -begin);
      begin = -begin;
      rise = -rise;
      top = from.z;
    }
  }

  double distance(double s) const { return std::sqrt(aside * aside + s * s); }
  /// Place on the rising side (s >= 0) at distance `d`; that next to the axis where none is.
  double place(double d) const { return d > aside ? std::sqrt((d - aside) * (d + aside)) : 0; }
};

/// The greatest of height - p(distance) along a slant.
class SlantSearch {
 public:
  SlantSearch(const CutterShape& shape, const Slant& slant) : shape_(shape), e_(slant) {}

  double value(double s) const {
    return e_.top - e_.rise * (e_.end - s) - shape_.height(e_.distance(s));
  }

  /// Over [low, high] with 0 <= low: before the axis the value only rises.
  double greatest(double low, double high) const {
    low = std::max(low, std::min(high, e_.place(shape_.flat_mm())));
    if (gain(high) >= 0) return value(high);
    if (gain(low) <= 0) return value(low);
    if (!shape_.has_cone()) return on_arc(shape_.first().ring, low, high);
    return over_pieces(low, high);
  }

 private:
  /// Derivative of value() at s >= 0.
  double gain(double s) const {
    const double d = e_.distance(s);
    return s > 0 ? e_.rise - shape_.slope(d) * s / d : e_.rise;
  }

  double over_pieces(double low, double high) const {
    const double cone_low = e_.place(shape_.first().end_mm);
    if (low < cone_low && (cone_low >= high || gain(cone_low) <= 0))
      return on_arc(shape_.first().ring, low, std::min(high, cone_low));
    low = std::max(low, cone_low);
    const double cone_high = e_.place(shape_.last().begin_mm);
    if (low < cone_high && (cone_high >= high || gain(cone_high) <= 0))
      return on_cone(low, std::min(high, cone_high));
    return on_arc(shape_.last().ring, std::max(low, cone_high), high);
  }

  /// There the slope along the segment is the cone's times s / d, so s / d = rise / cone's slope.
  double on_cone(double low, double high) const {
    const double ratio = std::min(1.0, e_.rise / shape_.cone_slope());
    const double root = std::sqrt((1 - ratio) * (1 + ratio));
    return value(root > 0 ? std::clamp(e_.aside * ratio / root, low, high) : high);
  }

  double on_arc(const CutterShape::Ring& ring, double low, double high) const {
    if (ring.rounding_mm <= 0) return value(high);
    if (ring.radius_mm > 0) return on_ring(ring, low, high);
    const double s = e_.rise / std::sqrt(1 + e_.rise * e_.rise) * e_.place(ring.rounding_mm);
    return value(std::clamp(s, low, high));
  }

  /// First guess: the contact distance for the slope along the segment at about that distance.
  double guess(const CutterShape::Ring& ring) const {
    const auto at = [&](double slope) {
      return ring.radius_mm + ring.rounding_mm * slope / std::sqrt(1 + slope * slope);
    };
    const double d = at(e_.rise), s = e_.place(d);
    return s > 0 ? at(e_.rise * d / s) : d;
  }

  /// sin(phi) s / d - rise cos(phi), where phi is the angle on the arc, times the rounding: it has
  /// the sign of -gain() and rises over the whole arc.
  double on_ring(const CutterShape::Ring& ring, double low, double high) const {
    double d_low = e_.distance(low), d_high = e_.distance(high), d = guess(ring);
    for (int step = 0;; ++step) {
      if (!(d > d_low && d < d_high)) d = (d_low + d_high) / 2;
      const double s = std::clamp(e_.place(d), low, high), out = d - ring.radius_mm;
      const double root =
          std::sqrt(std::max(0.0, (ring.rounding_mm - out) * (ring.rounding_mm + out)));
      const double off = out * s / d - e_.rise * root;
      const double slope = gain(s);
      const double excess = slope > 0 ? slope * (high - s) : slope * (low - s);
      if (excess <= kContactError_mm / 2 || step == kMostSteps) return value(s) + excess;
      (off > 0 ? d_high : d_low) = d;
      (off > 0 ? high : low) = s;
      d -= off / (s / d + out * e_.aside * e_.aside / (d * d * s) + e_.rise * out / root);
    }
  }

  const CutterShape& shape_;
  const Slant& e_;
};

void lift_over_upright(const CutterShape& shape, const Vec3& from, const Vec3& to,
                       GreatestLift& greatest) {
  const double d =
      std::sqrt(std::min(from.x * from.x + from.y * from.y, to.x * to.x + to.y * to.y));
  if (d <= shape.reach_mm() + kReachSlack_mm)
    greatest.take(std::max(from.z, to.z) - shape.height(d));
}

/// Lift over one segment, see lift_over_triangle(). Closed forms but for rings, where a bracketed
/// Newton search ends in an upper bound that its tangent proves by concavity.
void lift_over_edge(const CutterShape& shape, const Vec3& from, const Vec3& to,
                    GreatestLift& greatest) {
  // Only as far out as the higher end could still lift beyond what is known.
  const double reach = shape.distance_below(std::max(from.z, to.z) - greatest.known);
  if (reach < 0) return;
  const double dx = to.x - from.x, dy = to.y - from.y, squared = dx * dx + dy * dy;
  const double area = dx * from.y - dy * from.x, wide = reach + kReachSlack_mm;
  if (area * area > wide * wide * squared * (1 + kUnitRounding)) return;
  const double length = std::sqrt(squared);
  if (length < kUprightLength_mm) return lift_over_upright(shape, from, to, greatest);
  const Slant slant(from, to, length);
  const double half = slant.place(wide);
  const double low = std::max(slant.begin, -half), high = std::min(slant.end, half);
  if (low > high) return;
  const double nearest = slant.distance(std::clamp(0.0, low, high));
  if (slant.top - slant.rise * (slant.end - high) - shape.height(nearest) <= greatest.known) return;
  const SlantSearch search(shape, slant);
  greatest.take(high <= 0 ? search.value(high) : search.greatest(std::max(low, 0.0), high));
}

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
