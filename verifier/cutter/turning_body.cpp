#include "verifier/cutter/turning_body.h"

#include <algorithm>
#include <cmath>

#include "verifier/cutter/tilted_box.h"
#include "verifier/cutter/turning_looks.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// How often a move is looked at for one distance, at most. Some twenty are what it takes.
constexpr int kMostLooks = 400;
/// A turn that is no more than rounding: a tenth of a picometre on a tool of 100 mm.
constexpr double kSameAxis_rad = 1e-12;
/// A slope below this share of that at the stretch's other end: the least is near there.
constexpr double kLevelShare = 0.02;
/// How low a function may be between two places whose values and slopes are given, that bends down
/// by no more than `bend`: less (bend/2)(t - a)(b - t) it is convex, and above its tangents.
double least_between(double fa, double sa, double fb, double sb, double width, double bend) {
  const double down = sa - bend * width / 2, up = sb + bend * width / 2;
  if (down >= 0) return fa;
  if (up <= 0) return fb;
  return (fa * up - fb * down + width * down * up) / (up - down);
}

struct SineCosine {
  double sine = 0, cosine = 1;
};

/// Of small angles, as those of most moves are, by their series to the last bit.
SineCosine sine_cosine(double angle) {
  constexpr double kSmall = 0.1;
  if (std::abs(angle) > kSmall) return {std::sin(angle), std::cos(angle)};
  const double q = angle * angle;
  return {angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72)))),
          1 - q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * (1 - q / 90))))};
}

/// A unit vector across another one.
Vec3 across_any(const Vec3& axis) {
  return model::normalized(cross(axis, std::abs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
}

}  // namespace

TurningBody::TurningBody(const CutterProfile& profile, const Vec3& from, const Vec3& to,
                         const Vec3& axis_from, const Vec3& axis_to, double lift_mm)
    : from_(from),
      delta_(to - from),
      axis_(model::normalized(axis_from)),
      lift_mm_(lift_mm),
      up_mm_(lift_mm + profile.core_mm) {
  Vec3 across = axis_to - axis_ * dot(axis_, axis_to);
  // Once more: of a small turn most of it is rounding along the axis.
  across -= axis_ * dot(axis_, across);
  if (length(across) < kSameAxis_rad) {
    side_ = across_any(axis_);
  } else {
    side_ = model::normalized(across);
    turn_rad_ = model::angle_between(axis_, axis_to);
  }
  end_axis_ = axis(1);
  spin_rad_ = cross(axis_, side_) * turn_rad_;
  know_core();
}

void TurningBody::know_core() {
  core_from_ = core(0), core_chord_ = core(1) - core_from_, core_ = core(0.5);
  const double turn = turn_rad_, half = turn / 2, lift = std::abs(up_mm_);
  const Vec3 side_half_way = side_ * std::cos(half) - axis_ * std::sin(half);
  const double speed = length(delta_ + side_half_way * (up_mm_ * turn)), off = lift * turn * half;
  core_speed_mm_ = speed + off, least_speed_mm_ = std::max(0.0, speed - off);
  core_bend_mm_ = turn * turn * lift;
  const double tip_speed = length(delta_);
  // About the core, and about the tip.
  bend_mm_ = std::min(turn * turn * (core_speed_mm_ / 2 + lift) + 2 * turn * core_speed_mm_,
                      turn * turn * (lift + tip_speed / 2) + 2 * turn * tip_speed);
}

Vec3 TurningBody::axis(double t) const {
  const SineCosine at = sine_cosine(turn_rad_ * t);
  return axis_ * at.cosine + side_ * at.sine;
}

model::Box3 TurningBody::cores() const {
  model::Box3 box;
  box.add(core_from_), box.add(core_from_ + core_chord_);
  // The core keeps to its chord but for this.
  return box.grown(core_bend_mm_ / 8);
}

Vec3 TurningBody::turned(const Vec3& v, double by) const {
  const Vec3 about = cross(axis_, side_);
  const auto [s, c] = sine_cosine(turn_rad_ * by);
  return v * c + cross(about, v) * s + about * (dot(about, v) * (1 - c));
}

BodyDistance TurningBody::standing(const CutterProfile& profile, const Vec3& p, double t) const {
  const Vec3 up = axis(t), w = p - tip(t) - up * lift_mm_;
  const double height = dot(w, up);
  const Vec3 out = w - up * height;
  const double rho = length(out);
  const ProfileDistance d = closed_distance(profile, rho, height);
  return {d.value, out * (rho > 0 ? d.by_rho / rho : 0) + up * d.by_height, 0};
}

TurnLook TurningBody::look(const CutterProfile& profile, const Vec3& p, double t) const {
  TurnLook out{t, standing(profile, p, t), 0, 0};
  out.slope = -dot(out.here.gradient, delta_ + cross(spin_rad_, p - tip(t)));
  if (profile.is_ball()) out.over_core_mm = dot(p - tip(t), axis(t)) - up_mm_;
  return out;
}

/// Where to look next in a stretch: where the slope would vanish were it linear, or by turns where
/// the tangents meet, which finds a kink. Where the least is near one end, on the other side of it,
/// so far away that the rest is most often done with.
double TurningBody::next_look(const TurnStretch& s, bool by_tangents) {
  const double width = s.b.t - s.a.t, steepest = std::max(std::abs(s.a.slope), std::abs(s.b.slope));
  const bool falls = s.a.slope<-kLevelShare * steepest, rises = s.b.slope> kLevelShare * steepest;
  if (falls && rises) {
    const double bends = s.b.slope - s.a.slope;
    const double meet = (s.a.here.value - s.b.here.value + s.b.slope * width) / bends;
    const double t = s.a.t + (by_tangents ? meet : -s.a.slope * width / bends);
    if (t > s.a.t && t < s.b.t) return t;
  }
  return falls ? s.b.t - TurnStretch::kNearEnd * width
               : s.a.t + (rises ? TurnStretch::kNearEnd : 0.5) * width;
}

/// Where on the chord of the core's way a place is nearest to it.
double TurningBody::nearest_on_chord(const Vec3& p) const {
  const double square = model::length_squared(core_chord_);
  return square > 0 ? std::clamp(dot(p - core_from_, core_chord_) / square, 0.0, 1.0) : 0;
}

/// Of a whole ball that has its core above the place at all times it is the way to the core that
/// counts. Half its square, F, has F' = q·q' and F'' = |q'|² + q·q'' with q from the place to the
/// core: where that is positive at all times, m at least, F is convex and Newton's steps lead to
/// its least, below which F(t) is by F'(t)²/2m at most. Nothing of other places and moves, and
/// where that does not end.
std::optional<TurningBody::Least> TurningBody::least_of_ball(const CutterProfile& profile,
                                                             const Vec3& p, double bend,
                                                             double beyond_mm,
                                                             double precision_mm) const {
  constexpr int kMostNewtonSteps = 8;
  const Vec3 from = p - core_from_;
  if (!profile.is_whole_ball() ||
      std::max(dot(from, axis_), dot(from - core_chord_, end_axis_)) >= -bend / 8)
    return std::nullopt;
  double t = nearest_on_chord(p);
  const double to_chord = length(from - core_chord_ * t);
  const double bound = to_chord - core_bend_mm_ / 8 - profile.rounding_mm - kDistanceRounding_mm;
  if (bound > beyond_mm) return Least{{bound, {}, 0}, 0};
  const double farthest = to_chord + length(core_chord_) + core_bend_mm_ / 8;
  const double bends = least_speed_mm_ * least_speed_mm_ - farthest * core_bend_mm_;
  if (!(bends > 0)) return std::nullopt;
  for (int n = 0; n < kMostNewtonSteps; ++n) {
    const SineCosine at = sine_cosine(turn_rad_ * t);
    const Vec3 up = axis_ * at.cosine + side_ * at.sine,
               aside = side_ * at.cosine - axis_ * at.sine;
    const Vec3 q = from_ + delta_ * t + up * up_mm_ - p;
    const Vec3 way = delta_ + aside * (up_mm_ * turn_rad_);
    const double slope = dot(q, way), far = length(q);
    const bool at_end = (t <= 0 && slope >= 0) || (t >= 1 && slope <= 0);
    // far − √(far² − s²/m), by which the way may be shorter.
    const double left = at_end ? 0 : slope * slope / bends;
    const double rest = far * far - left;
    const double slack = rest > 0 ? left / (far + std::sqrt(rest)) : far;
    if (slack <= precision_mm && far > 0)
      return Least{{far - profile.rounding_mm, q / -far, slack}, t};
    const double bend_here = dot(way, way) - turn_rad_ * turn_rad_ * up_mm_ * dot(q, up);
    t = std::clamp(t - slope / std::max(bend_here, bends), 0.0, 1.0);
  }
  return std::nullopt;
}

double TurningBody::bound(const CutterProfile& profile, const Vec3& p, const Vec3& half) const {
  const double radius = length(half);
  const TurnLook at = look(profile, p, 0.5);
  return at.here.value - reach_of(at.here.gradient, half) -
         (std::abs(at.slope) + turn_rad_ * radius) / 2 - bend_mm(distance(p, core_) + radius) / 8 -
         kDistanceRounding_mm;
}

TurningBody::Least TurningBody::least(const CutterProfile& profile, const Vec3& p, double beyond_mm,
                                      double precision_mm) const {
  const double bend = bend_mm(distance(p, core_));
  if (const auto by_core = least_of_ball(profile, p, bend, beyond_mm, precision_mm))
    return *by_core;
  double dropped = std::numeric_limits<double>::infinity();
  TurnStretches heap;
  const auto add = [&](const TurnLook& a, const TurnLook& b) {
    const double width = b.t - a.t;
    // Below the core of a ball at all times, it is the way to its centre that counts.
    const bool by_core = profile.is_whole_ball() &&
                         std::max(a.over_core_mm, b.over_core_mm) < -bend * width * width / 8;
    const double bound = least_between(a.here.value, a.slope, b.here.value, b.slope, width,
                                       by_core ? core_bend_mm_ : bend);
    if (bound > beyond_mm)
      dropped = beyond_mm;
    else
      heap.push({a, b, bound});
  };
  const TurnLook begin = look(profile, p, 0), end = look(profile, p, 1);
  TurnLook best = end.here.value < begin.here.value ? end : begin;
  add(begin, end);
  for (int n = 0; n < kMostLooks && heap.lowest() < best.here.value - precision_mm; ++n) {
    const TurnStretch s = heap.pop();
    const double t = next_look(s, n % 2 == 1);
    if (!(t > s.a.t && t < s.b.t)) {  // no number between its ends
      heap.push({s.a, s.b, std::min(s.a.here.value, s.b.here.value)});
      continue;
    }
    const TurnLook here = look(profile, p, t);
    if (here.here.value < best.here.value) best = here;
    add(s.a, here), add(here, s.b);
  }
  Least out{best.here, best.t};
  out.distance.slack_mm =
      std::max(0.0, best.here.value - std::min({best.here.value, heap.lowest(), dropped}));
  return out;
}

}  // namespace limitgauge::verifier
