// Bounds of the space that a turning body sweeps, over cells; CERTIFICATE.md, section 12.

#include <algorithm>
#include <cmath>

#include "verifier/cutter/turning_body.h"
#include "verifier/cutter/turning_looks.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// How often a move is looked at for a bound over a cell, at most, whose loss is then what time
/// still adds to it.
constexpr int kMostBoundLooks = 80;
/// Time is cut up no further where it takes less than this share of what the cell's size takes.
constexpr double kShareOfSize = 0.05;

double largest_control(const std::array<double, 16>& v) {
  return *std::max_element(v.begin(), v.end());
}

}  // namespace

/// A part of a move about the time at which a cell's middle is nearest.
struct TurningBody::Around {
  double from = 0, to = 0;
  Vec3 velocity;                     ///< of the tool's material where the middle is
  double radius_mm = 0, far_mm = 0;  ///< of the cell, and from the core to its middle
};

/// Of a whole ball that has its core above all the points at all times: a lower bound of d over
/// their hull, by the chord of the core's way. No bound of other profiles and places.
double TurningBody::bound_by_chord(const CutterProfile& profile, std::span<const Vec3> points,
                                   const Vec3& middle, double bend) const {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  if (!profile.is_whole_ball()) return kNone;
  const Vec3 &from = core_from_, &along = core_chord_;
  const double t = nearest_on_chord(middle);
  const Vec3 away = model::normalized(middle - from - along * t);
  const double ahead = std::max(0.0, dot(along, away));
  double highest = kNone, least = std::numeric_limits<double>::infinity();
  for (const Vec3& p : points) {
    const Vec3 q = p - from;
    highest = std::max({highest, dot(q, axis_), dot(q - along, end_axis_)});
    least = std::min(least, dot(q, away) - ahead);
  }
  if (highest >= -bend / 8) return kNone;
  return least - core_bend_mm_ / 8 - profile.rounding_mm - kDistanceRounding_mm;
}

/// A bound over a hull, by planes at one place of it and many times.
struct TurningBody::LowerSearch {
  const TurningBody& body;
  const CutterProfile& profile;
  std::span<const Vec3> points;
  Vec3 middle;
  double bend = 0;

  /// Values at the points, at both ends of a stretch, of the plane of one of them.
  struct Plane {
    double at = 0, other = 0;  ///< constants of the gradients below
    Vec3 at_gradient, other_gradient;
  };
  Plane plane(const TurnLook& own, const TurnLook& far) const {
    const Vec3 turned = body.turned(own.here.gradient, far.t - own.t);
    return {own.here.value - dot(own.here.gradient, middle),
            own.here.value - dot(own.here.gradient, middle - body.tip(own.t)) -
                dot(turned, body.tip(far.t)),
            own.here.gradient, turned};
  }
  double bound(const TurnLook& a, const TurnLook& b) const {
    const Plane by_a = plane(a, b), by_b = plane(b, a);
    double weight = a.slope >= 0 ? 1 : 0;  // of a
    if (a.slope < 0 && b.slope > 0) weight = b.slope / (b.slope - a.slope);
    const double rest = 1 - weight;
    const Vec3 at_a = by_a.at_gradient * weight + by_b.other_gradient * rest;
    const Vec3 at_b = by_a.other_gradient * weight + by_b.at_gradient * rest;
    double least_a = std::numeric_limits<double>::infinity(), least_b = least_a;
    for (const Vec3& p : points) {
      least_a = std::min(least_a, dot(at_a, p));
      least_b = std::min(least_b, dot(at_b, p));
    }
    const double width = b.t - a.t;
    return std::min(least_a + by_a.at * weight + by_b.other * rest,
                    least_b + by_a.other * weight + by_b.at * rest) -
           bend * width * width / 8;
  }
  /// What the plane at one time leaves then.
  double at_once(const TurnLook& look) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& p : points) least = std::min(least, dot(look.here.gradient, p - middle));
    return look.here.value + least;
  }
};

double TurningBody::lower(const CutterProfile& profile, std::span<const Vec3> points,
                          const Vec3& middle, double enough_mm) const {
  double radius = 0;
  for (const Vec3& p : points) radius = std::max(radius, distance(p, middle));
  const double bend = bend_mm(radius + distance(middle, core_));
  const double by_chord = bound_by_chord(profile, points, middle, bend);
  if (by_chord >= enough_mm) return by_chord;
  const Least at = least(profile, middle, enough_mm + radius + kDistanceRounding_mm,
                         turning_precision_mm(radius));
  const double value = at.distance.value - at.distance.slack_mm, coarse = value - radius;
  if (coarse >= enough_mm || (std::isfinite(enough_mm) && value < enough_mm)) return coarse;
  LowerSearch search{*this, profile, points, middle, bend};
  TurnStretches heap;
  const auto add = [&](const TurnLook& a, const TurnLook& b) {
    if (b.t > a.t) heap.push({a, b, search.bound(a, b)});
  };
  const TurnLook lowest = look(profile, middle, at.t);
  add(look(profile, middle, 0), lowest), add(lowest, look(profile, middle, 1));
  const double at_once = search.at_once(lowest);
  const double goal = std::min(
      enough_mm, at_once - std::max(kShareOfSize * (lowest.here.value - at_once), kAlongTurn_mm));
  for (int n = 0; n < kMostBoundLooks && heap.lowest() < goal; ++n) {
    const TurnStretch s = heap.pop();
    const double width = s.b.t - s.a.t;
    const double share = s.a.t == at.t   ? TurnStretch::kNearEnd
                         : s.b.t == at.t ? 1 - TurnStretch::kNearEnd
                                         : 0.5;
    const TurnLook here = look(profile, middle, s.a.t + share * width);
    add(s.a, here), add(here, s.b);
  }
  return std::max({by_chord, coarse, heap.lowest()});
}

/// Of a ball: what its centre passes by, on the chord of a part of its path.
void TurningBody::rolling(const CutterProfile& profile, const Bezier& cell, double a, double b,
                          std::array<double, 16>& out) const {
  const Vec3 from = core(a), along = core(b) - from;
  const double square = model::length_squared(along), turn = turn_rad_ * (b - a);
  const double bow = turn * turn * std::abs(up_mm_) / 8;
  for (int k = 0; k < 16; ++k) {
    const Vec3 w = cell.control(k) - from;
    const double t = square > 0 ? std::clamp(dot(w, along) / square, 0.0, 1.0) : 0;
    out[k] = length(w - along * t) - profile.rounding_mm + bow;
  }
}

/// The profile as it stands at one time, moved as it moves then at the cell's middle.
void TurningBody::following(const CutterProfile& profile, const Bezier& cell, const Least& at,
                            const Around& around, std::array<double, 16>& out) const {
  const double t = at.t;
  const Vec3 up = axis(t), aside = turned(side_, t), third = cross(up, aside);
  const Vec3 base = tip(t) + up * lift_mm_;
  const auto in_tool = [&](const Vec3& v) {
    return Vec3{dot(v, aside), dot(v, third), dot(v, up)};
  };
  Bezier own;
  for (int k = 0; k < 16; ++k) own.set(k, in_tool(cell.control(k) - base));
  const Vec3 way = in_tool(around.velocity);
  body_values(profile, SweptBody(way * (around.from - t), way * (around.to - t)), own, out);
  const double span = std::max(t - around.from, around.to - t), turn = turn_rad_ * span;
  const double speed = core_speed_mm_, lift = std::abs(up_mm_);
  const double far = around.far_mm + around.radius_mm + speed * span;
  const double aside_mm = turn * (around.radius_mm + speed * span) + turn * turn * (far + lift) / 2;
  for (double& value : out) value += aside_mm;
}

void TurningBody::values(const CutterProfile& profile, const Bezier& cell,
                         std::array<double, 16>& out) const {
  const Vec3 centre = verifier::middle(cell);
  const double radius = control_radius(cell, centre);
  const Least at =
      least(profile, centre, std::numeric_limits<double>::infinity(), turning_precision_mm(radius));
  for (int k = 0; k < 16; ++k) out[k] = standing(profile, cell.control(k), at.t).value;
  auto offer = [&, best = largest_control(out)](const std::array<double, 16>& other) mutable {
    if (largest_control(other) >= best) return;
    out = other, best = largest_control(out);
  };
  std::array<double, 16> other{};
  const Vec3 velocity = delta_ + cross(spin_rad_, centre - tip(at.t));
  const double speed = length(velocity);
  if (!(speed > 0)) return;
  for (const double share : {1.0, 0.5}) {
    const double half = share * radius / speed;
    const double a = std::max(0.0, at.t - half), b = std::min(1.0, at.t + half);
    if (profile.is_whole_ball())
      rolling(profile, cell, a, b, other);
    else
      following(profile, cell, at, {a, b, velocity, radius, distance(centre, core(at.t))}, other);
    offer(other);
  }
}

}  // namespace limitgauge::verifier
