#include "verifier/cutter/turning_body.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "verifier/cutter/tilted_box.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// How often a move is looked at for one distance, at most. Some twenty are what it takes.
constexpr int kMostLooks = 400;
/// The same for a bound over a cell, whose loss is then what time still adds to it.
constexpr int kMostBoundLooks = 80;
/// A turn that is no more than rounding: a tenth of a picometre on a tool of 100 mm.
constexpr double kSameAxis_rad = 1e-12;
/// A slope below this share of that at the stretch's other end: the least is near there.
constexpr double kLevelShare = 0.02;
/// Time is cut up no further where it takes less than this share of what the cell's size takes.
constexpr double kShareOfSize = 0.05;
/// Where a stretch has its least near one end, how far from there it is cut.
constexpr double kNearEnd = 0.25;

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

double largest(const std::array<double, 16>& v) {
  return *std::max_element(v.begin(), v.end());
}

}  // namespace

/// The profile as it stands at t: its distance to a place, and how fast that grows with t.
struct TurningBody::Look {
  double t = 0;
  BodyDistance here;
  double slope = 0;
  double over_core_mm = 0;  ///< how far up the axis the place is from the core
};

/// Between two looks, with the least that may be in it.
struct TurningBody::Stretch {
  Look a, b;
  double bound = 0;
};

/// Stretches, the lowest first; of one search at a time in a thread.
class TurningBody::StretchHeap {
 public:
  StretchHeap() { heap().clear(); }
  double lowest() const {
    return heap().empty() ? std::numeric_limits<double>::infinity() : heap().front().bound;
  }
  void push(const Stretch& stretch) {
    heap().push_back(stretch);
    std::push_heap(heap().begin(), heap().end(), higher);
  }
  Stretch pop() {
    std::pop_heap(heap().begin(), heap().end(), higher);
    const Stretch lowest = heap().back();
    heap().pop_back();
    return lowest;
  }

 private:
  static bool higher(const Stretch& x, const Stretch& y) { return x.bound > y.bound; }
  static std::vector<Stretch>& heap() {
    thread_local std::vector<Stretch> kept;
    return kept;
  }
};

/// A part of a move about the time at which a cell's middle is nearest.
struct TurningBody::Around {
  double from = 0, to = 0;
  Vec3 velocity;                     ///< of the tool's material where the middle is
  double radius_mm = 0, far_mm = 0;  ///< of the cell, and from the core to its middle
};

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

TurningBody::Look TurningBody::look(const CutterProfile& profile, const Vec3& p, double t) const {
  Look out{t, standing(profile, p, t), 0, 0};
  out.slope = -dot(out.here.gradient, delta_ + cross(spin_rad_, p - tip(t)));
  if (profile.is_ball()) out.over_core_mm = dot(p - tip(t), axis(t)) - up_mm_;
  return out;
}

/// Where to look next in a stretch: where the slope would vanish were it linear, or by turns where
/// the tangents meet, which finds a kink. Where the least is near one end, on the other side of it,
/// so far away that the rest is most often done with.
double TurningBody::next_look(const Stretch& s, bool by_tangents) {
  const double width = s.b.t - s.a.t, steepest = std::max(std::abs(s.a.slope), std::abs(s.b.slope));
  const bool falls = s.a.slope<-kLevelShare * steepest, rises = s.b.slope> kLevelShare * steepest;
  if (falls && rises) {
    const double bends = s.b.slope - s.a.slope;
    const double meet = (s.a.here.value - s.b.here.value + s.b.slope * width) / bends;
    const double t = s.a.t + (by_tangents ? meet : -s.a.slope * width / bends);
    if (t > s.a.t && t < s.b.t) return t;
  }
  return falls ? s.b.t - kNearEnd * width : s.a.t + (rises ? kNearEnd : 0.5) * width;
}

/// Where on the chord of the core's way a place is nearest to it.
double TurningBody::nearest_on_chord(const Vec3& p) const {
  const double square = model::length_squared(core_chord_);
  return square > 0 ? std::clamp(dot(p - core_from_, core_chord_) / square, 0.0, 1.0) : 0;
}

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

/// Of a whole ball that has its core above the place at all times it is the way to the core that
/// counts. Half its square, F, has F' = q·q' and F'' = |q'|² + q·q'' with q from the place to the
/// core: where that is positive at all times, m at least, F is convex and Newton's steps lead to
/// its least, below which F(t) is by F'(t)²/2m at most. Nothing of other places and moves, and
/// where that does not end.
std::optional<TurningBody::Least> TurningBody::least_of_ball(const CutterProfile& profile,
                                                             const Vec3& p, double bend,
                                                             double beyond_mm,
                                                             double precision_mm) const {
  constexpr int kMostSteps = 8;
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
  for (int n = 0; n < kMostSteps; ++n) {
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
  const Look at = look(profile, p, 0.5);
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
  StretchHeap heap;
  const auto add = [&](const Look& a, const Look& b) {
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
  const Look begin = look(profile, p, 0), end = look(profile, p, 1);
  Look best = end.here.value < begin.here.value ? end : begin;
  add(begin, end);
  for (int n = 0; n < kMostLooks && heap.lowest() < best.here.value - precision_mm; ++n) {
    const Stretch s = heap.pop();
    const double t = next_look(s, n % 2 == 1);
    if (!(t > s.a.t && t < s.b.t)) {  // no number between its ends
      heap.push({s.a, s.b, std::min(s.a.here.value, s.b.here.value)});
      continue;
    }
    const Look here = look(profile, p, t);
    if (here.here.value < best.here.value) best = here;
    add(s.a, here), add(here, s.b);
  }
  Least out{best.here, best.t};
  out.distance.slack_mm =
      std::max(0.0, best.here.value - std::min({best.here.value, heap.lowest(), dropped}));
  return out;
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
  Plane plane(const Look& own, const Look& far) const {
    const Vec3 turned = body.turned(own.here.gradient, far.t - own.t);
    return {own.here.value - dot(own.here.gradient, middle),
            own.here.value - dot(own.here.gradient, middle - body.tip(own.t)) -
                dot(turned, body.tip(far.t)),
            own.here.gradient, turned};
  }
  double bound(const Look& a, const Look& b) const {
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
  double at_once(const Look& look) const {
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
  StretchHeap heap;
  const auto add = [&](const Look& a, const Look& b) {
    if (b.t > a.t) heap.push({a, b, search.bound(a, b)});
  };
  const Look lowest = look(profile, middle, at.t);
  add(look(profile, middle, 0), lowest), add(lowest, look(profile, middle, 1));
  const double at_once = search.at_once(lowest);
  const double goal = std::min(
      enough_mm, at_once - std::max(kShareOfSize * (lowest.here.value - at_once), kAlongTurn_mm));
  for (int n = 0; n < kMostBoundLooks && heap.lowest() < goal; ++n) {
    const Stretch s = heap.pop();
    const double width = s.b.t - s.a.t;
    const double share = s.a.t == at.t ? kNearEnd : s.b.t == at.t ? 1 - kNearEnd : 0.5;
    const Look here = look(profile, middle, s.a.t + share * width);
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
  auto offer = [&, best = largest(out)](const std::array<double, 16>& other) mutable {
    if (largest(other) >= best) return;
    out = other, best = largest(out);
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
