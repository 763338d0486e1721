#include "simulator/sweep/turning/turning_move.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

/// Stretches of one move for one distance, at most: a dozen is what most take, and none was seen to
/// take two hundred.
constexpr std::size_t kMostAlongTurn = 4000;

struct TurnedBy {
  double sine, cosine;
};

/// Most moves turn by little, where a few terms of the series are exact to the last bit.
inline TurnedBy turned_by(double angle) {
  if (std::abs(angle) > 0.05) return {std::sin(angle), std::cos(angle)};
  const double q = angle * angle;
  return {angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42))),
          1 - q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56)))};
}

/// D at one time of the move and its derivative by t.
struct TurnLook {
  double t = 0, value = 0, slope = 0;
  Vec3 gradient;
  double over_core = 0;  ///< how far up the axis the place is from the core, mm
};

TurnLook look_at(const CutterProfile& profile, const TurningMove& m, const Vec3& p, double t) {
  const Vec3 up = m.up(t), from_tip = p - m.tip(t);
  const double height = dot(from_tip, up);
  const Vec3 out = from_tip - up * height;
  const double rho = length(out);
  const MeridianSample s = profile.sample(rho, height);
  const Vec3 gradient = out * (rho > 0 ? s.g_rho / rho : 0.0) + up * s.g_z;
  // The tool's material passes the place with this velocity.
  const Vec3 velocity = m.delta + cross(cross(m.axis, m.side), from_tip) * m.turn_rad;
  return {t, s.distance, -dot(gradient, velocity), gradient, height - m.core_mm};
}

/// What holds all along a move for one place (PROOFS.md, P9).
struct TurnBends {
  TurnBends(const CutterProfile& profile, const TurningMove& m, const Vec3& p)
      : whole_ball(profile.is_ball() && profile.length() >= 2 * profile.corner_radius()) {
    const double turn = m.turn_rad;
    from_core = distance(p, m.core_half_way) + m.half_way_mm();
    of_core = turn * turn * std::abs(m.core_mm);
    general = turn * turn * from_core + 2 * turn * m.core_speed_mm + of_core;
  }
  /// Of D between two looks: below the core of a ball its centre is all that counts.
  double between(const TurnLook& a, const TurnLook& b) const {
    const double width = b.t - a.t;
    const bool below =
        whole_ball && std::max(a.over_core, b.over_core) < -general * width * width / 8;
    return below ? of_core : general;
  }

  bool whole_ball;
  double from_core = 0;  ///< the place is never farther from the core, mm
  double of_core = 0;    ///< |c″|
  double general = 0;    ///< |y″|
};

/// Between two looks, with a lower bound of D there.
struct TurnStretch {
  TurnLook a, b;
  double bend = 0, bound = 0;
};

/// Where the tangents of the convex function below D meet, that has D's values at both ends.
double bound_between(const TurnLook& a, const TurnLook& b, double bend) {
  const double width = b.t - a.t;
  const double down = a.slope - bend * width / 2, up = b.slope + bend * width / 2;
  if (down >= 0) return a.value;
  if (up <= 0) return b.value;
  return (a.value * up - b.value * down + width * down * up) / (up - down);
}

/// Where to look next. With the least between: by turns where the slope would vanish were it
/// linear, and where the tangents meet, which finds a kink. With the least at one end: near there,
/// so that the rest is done with.
double next_time(const TurnStretch& s, std::size_t step) {
  constexpr double kLevel = 0.02, kNearest = 0.03, kFarthest = 0.3;
  const double width = s.b.t - s.a.t, bends = s.b.slope - s.a.slope;
  const double steepest = std::max(std::abs(s.a.slope), std::abs(s.b.slope));
  const bool falls = s.a.slope<-kLevel * steepest, rises = s.b.slope> kLevel * steepest;
  double t = s.a.t + width / 2;
  if (falls && rises) {
    const double meet = (s.a.value - s.b.value + s.b.slope * width) / bends;
    t = s.a.t + (step % 2 == 1 ? meet : -s.a.slope * width / bends);
  } else if (falls || rises) {
    const double share =
        bends > 0 ? std::clamp(s.bend * width / bends, kNearest, kFarthest) : kFarthest;
    t = rises ? s.a.t + share * width : s.b.t - share * width;
  }
  return t > s.a.t && t < s.b.t ? t : s.a.t + width / 2;
}

/// The stretches of a move and a heap of them by their bounds: about a tip that stands still as its
/// tool turns the distance is the same all along, and thousands are looked at.
struct TurnStretches {
  struct Rank {
    double bound;
    std::size_t stretch;
    bool operator<(const Rank& o) const { return bound > o.bound; }
  };

  void clear() { all.clear(), ranks.clear(); }
  const TurnStretch& lowest() const { return all[ranks.front().stretch]; }
  void add(const TurnStretch& s) {
    all.push_back(s);
    rank(all.size() - 1);
  }
  /// Two in place of the lowest.
  void split(const TurnStretch& first, const TurnStretch& second) {
    const std::size_t low = ranks.front().stretch;
    std::pop_heap(ranks.begin(), ranks.end());
    ranks.pop_back();
    all[low] = first;
    rank(low);
    add(second);
  }

  std::vector<TurnStretch> all;
  std::vector<Rank> ranks;

 private:
  void rank(std::size_t stretch) {
    ranks.push_back({all[stretch].bound, stretch});
    std::push_heap(ranks.begin(), ranks.end());
  }
};

/// Best first over the stretches of a move.
class TurnSearchAlong {
 public:
  TurnSearchAlong(const CutterProfile& profile, const TurningMove& move, const Vec3& p)
      : profile_(profile), move_(move), p_(p), bends_(profile, move, p), stretches_(room()) {
    stretches_.clear();
  }

  std::optional<SweptSample> least(double bound, double within);

 private:
  TurnStretch between(const TurnLook& a, const TurnLook& b) const {
    const double bend = bends_.between(a, b);
    return {a, b, bend, bound_between(a, b, bend)};
  }
  SweptSample settled() const;
  /// Of one search at a time in a thread.
  static TurnStretches& room() {
    thread_local TurnStretches kept;
    return kept;
  }

  const CutterProfile& profile_;
  const TurningMove& move_;
  const Vec3& p_;
  TurnBends bends_;
  TurnLook best_;
  TurnStretches& stretches_;
};

std::optional<SweptSample> TurnSearchAlong::least(double bound, double within) {
  const TurnLook begin = look_at(profile_, move_, p_, 0), end = look_at(profile_, move_, p_, 1);
  best_ = end.value < begin.value ? end : begin;
  stretches_.add(between(begin, end));
  for (std::size_t step = 0; stretches_.all.size() < kMostAlongTurn; ++step) {
    const TurnStretch s = stretches_.lowest();
    if (s.bound >= bound) return std::nullopt;
    if (best_.value - s.bound <= within) break;
    const double t = next_time(s, step);
    if (!(t > s.a.t && t < s.b.t)) break;  // no number lies between
    const TurnLook here = look_at(profile_, move_, p_, t);
    if (here.value < best_.value) best_ = here;
    stretches_.split(between(s.a, here), between(here, s.b));
  }
  return best_.value < bound ? std::optional(settled()) : std::nullopt;
}

/// A plane under all of D, by the best look alone or by a mean of it and the look beside it towards
/// which D falls: the slopes of both cancel.
SweptSample TurnSearchAlong::settled() const {
  const double before = std::max(0.0, best_.slope) * best_.t,
               after = std::max(0.0, -best_.slope) * (1 - best_.t);
  SweptSample out{best_.value, best_.gradient, best_.t, before + after};
  for (const TurnStretch& s : stretches_.all) {
    const TurnLook &a = s.a, &b = s.b;
    if ((a.t != best_.t && b.t != best_.t) || !(a.slope < 0 && b.slope > 0)) continue;
    const double share = b.slope / (b.slope - a.slope);
    const double meeting = share * a.value + (1 - share) * b.value + share * a.slope * (b.t - a.t);
    if (best_.value - meeting >= out.slack_mm) continue;
    out.slack_mm = std::max(0.0, best_.value - meeting);
    out.gradient = a.gradient * share + b.gradient * (1 - share);
  }
  return out;
}

/// The cutter at one time, as moves that do not turn are asked: upright at zero.
struct StandingCutter {
  StandingCutter(const TurningMove& m, const Vec3& p, const SweptSample& at) : e3(m.up(at.t)) {
    const Vec3 from_tip = p - m.tip(at.t);
    const double height = dot(from_tip, e3);
    const Vec3 out = from_tip - e3 * height;
    const double rho = length(out);
    e1 = rho > 0 ? out / rho : m.side * dot(m.axis, e3) - m.axis * dot(m.side, e3);
    e2 = cross(e3, e1);
    place = {rho, 0, height};
    sample = {at.distance, {dot(e1, at.gradient), dot(e2, at.gradient), dot(e3, at.gradient)}, 0};
  }
  Vec3 held(const Vec3& half) const {
    const auto along = [&](const Vec3& e) {
      return half.x * std::abs(e.x) + half.y * std::abs(e.y) + half.z * std::abs(e.z);
    };
    return {along(e1), along(e2), along(e3)};
  }

  Vec3 e1, e2, e3;
  SweptMove standing{{}, {}, 0};
  Vec3 place;
  SweptSample sample;
};

}  // namespace

TurningMove::TurningMove(const Vec3& from, const Vec3& to, const Vec3& axis_from,
                         const Vec3& axis_to, double core)
    : start(from), delta(to - from), axis(model::normalized(axis_from)), core_mm(core) {
  Vec3 across = axis_to - axis * dot(axis, axis_to);
  // Once more: of a small turn most of it is rounding along the axis.
  across -= axis * dot(axis, across);
  if (length(across) < kSameTurn_rad) {
    side = model::normalized(cross(axis, std::abs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  } else {
    side = model::normalized(across);
    turn_rad = std::atan2(length(across), dot(axis, axis_to));
  }
  const TurnedBy half = turned_by(turn_rad / 2), whole = turned_by(turn_rad);
  axis_half_way = axis * half.cosine + side * half.sine;
  axis_end = axis * whole.cosine + side * whole.sine;
  core_half_way = tip(0.5) + axis_half_way * core_mm;
  const Vec3 sideways = side * half.cosine - axis * half.sine;
  core_speed_mm =
      length(delta + sideways * (core_mm * turn_rad)) + std::abs(core_mm) * turn_rad * turn_rad / 2;
}

Vec3 TurningMove::up(double t) const {
  if (turn_rad == 0 || t == 0) return axis;
  if (t == 1) return axis_end;
  const TurnedBy by = turned_by(turn_rad * t);
  return axis * by.cosine + side * by.sine;
}

std::optional<SweptSample> turning_distance(const CutterProfile& profile, const TurningMove& move,
                                            const Vec3& p, double bound, double within_mm) {
  return TurnSearchAlong(profile, move, p).least(bound, std::max(within_mm, kLeastAlongMove_mm));
}

SweptSample standing_distance(const CutterProfile& profile, const TurningMove& move, const Vec3& p,
                              double t) {
  const TurnLook look = look_at(profile, move, p, t);
  return {look.value, look.gradient, t};
}

// Half the move is the way from its middle, and no place of the cutter's frame goes faster there
// than its core and what the turn adds.
bool cannot_be_below(const CutterProfile& profile, const TurningMove& m, const Vec3& p,
                     double bound) {
  const Vec3 &up = m.axis_half_way, from_tip = p - m.tip(0.5);
  const double height = dot(from_tip, up);
  const double rho = length(from_tip - up * height);
  const double far = distance(p, m.core_half_way) + m.half_way_mm();
  const double way = (m.core_speed_mm + m.turn_rad * far) / 2;
  return profile.sample(rho, height).distance - way >= bound;
}

double turning_sag(const CutterProfile& profile, const TurningMove& m, const Vec3& p,
                   const SweptSample& at, double reach) {
  const TurnBends bends(profile, m, p);
  if (m.turn_rad == 0) return at.slack_mm;
  const double way = m.core_speed_mm + m.turn_rad * (bends.from_core + reach);
  const double over_core = dot(p - m.core(at.t), m.up(at.t));
  if (bends.whole_ball && over_core + reach + way < 0) return at.slack_mm + bends.of_core / 2;
  return at.slack_mm + m.turn_rad * (reach + m.core_speed_mm) +
         (m.turn_rad * m.turn_rad * bends.from_core + bends.of_core) / 2;
}

double curvature_bound(const CutterProfile& profile, const TurningMove& move, const Vec3& p,
                       const SweptSample& at, double reach) {
  const StandingCutter c(move, p, at);
  return curvature_bound(profile, c.standing, c.place, c.sample, reach);
}

double outside_bound(const CutterProfile& profile, const TurningMove& move, const Vec3& p,
                     const SweptSample& at, const Vec3& half) {
  const StandingCutter c(move, p, at);
  return std::min(outside_bound(profile, c.standing, c.place, c.sample, c.held(half)),
                  curvature_bound(profile, c.standing, c.place, c.sample, length(half)));
}

}  // namespace limitgauge::simulator
