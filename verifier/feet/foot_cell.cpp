#include "verifier/feet/foot_cell.h"

#include <algorithm>
#include <cmath>

#include "verifier/feet/distance_polynomial.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr int kNewtonSteps = 30;
/// Halvings of a step that does not lead down.
constexpr int kStepHalvings = 40;
/// Halvings of a window at most: then it is below the last bit of the parameter.
constexpr int kWindowHalvings = 100;

/// A rectangle of a cell's parameters.
struct Window {
  double s0 = 0, s1 = 1, t0 = 0, t1 = 1;
};

/// f(x + (ds, dt)) ≥ f(x) + g·(ds, dt) + (ss·ds² + tt·dt²)/2 wherever the Hessian is within bounds:
/// |st| is shared out between the two in proportion to their own.
struct Curvature {
  double ss = 0, tt = 0;
  bool convex() const { return ss >= 0 && tt >= 0; }
};
Curvature least_curvature(double ss, double tt, double st) {
  if (ss > 0 && tt > 0) {
    const double left = 1 - st / std::sqrt(ss * tt);
    return {ss * left, tt * left};
  }
  return {ss - st, tt - st};
}

/// Least of g·x + c·x²/2 for x in [low, high].
double least_on(double g, double c, double low, double high) {
  if (c > 0) {
    const double x = std::clamp(-g / c, low, high);
    return x * (g + c * x / 2);
  }
  return std::min(low * (g + c * low / 2), high * (g + c * high / 2));
}

/// Least of a·b over b in a box.
double least_product(const Vec3& a, const FootCell::LocalBox& box) {
  return std::min(a.x * box[0].low, a.x * box[0].high) +
         std::min(a.y * box[1].low, a.y * box[1].high) +
         std::min(a.z * box[2].low, a.z * box[2].high);
}

struct Step {
  double ds = 0, dt = 0;
};

/// The least of the quadratic model g·x + xᵀHx/2 in the window about (s, t); H is made positive
/// definite first by leaving out the curvature of the patch.
Step downhill(const BezierJet& j, const Vec3& r, const Window& w, double s, double t) {
  const double gs = dot(r, j.du), gt = dot(r, j.dv);
  double hss = dot(j.du, j.du) + dot(r, j.duu), hst = dot(j.du, j.dv) + dot(r, j.duv),
         htt = dot(j.dv, j.dv) + dot(r, j.dvv);
  double det = hss * htt - hst * hst;
  if (hss <= 0 || det <= kSingular * hss * htt)
    hss = dot(j.du, j.du), hst = dot(j.du, j.dv), htt = dot(j.dv, j.dv),
    det = hss * htt - hst * hst;
  const double a0 = w.s0 - s, a1 = w.s1 - s, b0 = w.t0 - t, b1 = w.t1 - t;
  if (det > 0) {
    const double ds = (hst * gt - htt * gs) / det, dt = (hst * gs - hss * gt) / det;
    if (ds >= a0 && ds <= a1 && dt >= b0 && dt <= b1) return {ds, dt};
  }
  // The least lies on a side of the window.
  Step best;
  double least = 0;
  const auto consider = [&](double ds, double dt) {
    const double value = gs * ds + gt * dt + (hss * ds * ds + htt * dt * dt) / 2 + hst * ds * dt;
    if (value < least) least = value, best = {ds, dt};
  };
  for (const double a : {a0, a1})
    if (htt > 0) consider(a, std::clamp(-(gt + hst * a) / htt, b0, b1));
  for (const double b : {b0, b1})
    if (hss > 0) consider(std::clamp(-(gs + hst * b) / hss, a0, a1), b);
  return best;
}

struct Candidate {
  double s = 0, t = 0, squared = 0;
  double lower = 0;  ///< of half the squared distance over the window, if the curvature holds
};

/// Descends from (s, t) within the window, until the step is below kSettled_mm or the lower bound
/// shows that nothing there is below `half_best`.
Candidate descend(const Bezier& shape, const Vec3& p, const Window& w, double s, double t,
                  const Curvature& curvature, double half_best) {
  BezierJet j = jet(shape, s, t);
  Vec3 r = j.position - p;
  double squared = length_squared(r);
  bool settled = false;
  for (int n = 0;; ++n) {
    const double lower = squared / 2 + least_on(dot(r, j.du), curvature.ss, w.s0 - s, w.s1 - s) +
                         least_on(dot(r, j.dv), curvature.tt, w.t0 - t, w.t1 - t);
    if (settled || lower >= half_best || n >= kNewtonSteps) return {s, t, squared, lower};
    Step step = downhill(j, r, w, s, t);
    for (int halving = 0;; ++halving) {
      const double moved = length(j.du) * std::abs(step.ds) + length(j.dv) * std::abs(step.dt);
      const double s1 = std::clamp(s + step.ds, w.s0, w.s1),
                   t1 = std::clamp(t + step.dt, w.t0, w.t1);
      const BezierJet there = jet(shape, s1, t1);
      const Vec3 r1 = there.position - p;
      const double now = length_squared(r1);
      settled = moved < kSettled_mm || halving > kStepHalvings;
      // Near the foot the distance is level to rounding: there a step is trusted as it is.
      if (now <= squared + kLevelSquare * squared) {
        s = s1, t = t1, j = there, r = r1, squared = now;
        break;
      }
      if (settled) break;
      step = {step.ds / 2, step.dt / 2};
    }
  }
}

/// How a place is held, see Foot::aside_mm.
void describe_hold(const FootCell& cell, const Vec3& p, Foot& foot) {
  const BezierJet j = jet(cell.shape, foot.s, foot.t);
  const Vec3 r = j.position - p;
  if (cell.is_point) {
    foot.aside_mm = length(r - cell.vertex_normal * dot(r, cell.vertex_normal));
    return;
  }
  double aside[2] = {};
  const auto look = [&](double at, const Vec3& along, int low_side, int high_side, double& out) {
    const double pull = dot(r, along), size = length(along);
    const int side = pull > 0 ? low_side : high_side;
    const bool held = (pull > 0 ? at <= 0 : at >= 1) && cell.sides[side] != SurfaceFeature::smooth;
    if (!held && size > 0) out = std::abs(pull) / size;
    if (held && cell.sides[side] == SurfaceFeature::crease) foot.at_crease = true;
  };
  look(foot.s, j.du, 3, 1, aside[0]);
  look(foot.t, j.dv, 0, 2, aside[1]);
  foot.aside_mm = std::hypot(aside[0], aside[1]);
}

bool more_surely(const Foot& a, const Foot& b) {
  const double aside_a = a.aside_mm > kSettled_mm ? a.aside_mm : 0,
               aside_b = b.aside_mm > kSettled_mm ? b.aside_mm : 0;
  if (aside_a != aside_b) return aside_a < aside_b;
  return a.at_crease != b.at_crease ? b.at_crease : a.squared < b.squared;
}

class CellSearch {
 public:
  CellSearch(const FootCell& cell, std::uint32_t index, const Vec3& p, Foot& best)
      : cell_(cell),
        index_(index),
        p_(p),
        best_(best),
        size_mm_(std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) {}

  void run() {
    const Vec3 r = cell_.middle.position - p_;
    const double squared = length_squared(r);
    const Vec3 local{dot(r, cell_.frame[0]), dot(r, cell_.frame[1]), dot(r, cell_.frame[2])};
    const double ss = cell_.own_ss.low + least_product(local, cell_.ss),
                 tt = cell_.own_tt.low + least_product(local, cell_.tt),
                 st = std::max(-cell_.own_st.low - least_product(local, cell_.st),
                               cell_.own_st.high - least_product(-local, cell_.st));
    const Curvature c = least_curvature(ss, tt, st);
    const double gs = dot(r, cell_.middle.du), gt = dot(r, cell_.middle.dv);
    const double lower =
        squared / 2 + least_on(gs, c.ss, -0.5, 0.5) + least_on(gt, c.tt, -0.5, 0.5);
    if (lower >= half_best()) return;
    if (!c.convex()) {
      split(distance_polynomial(cell_.shape, p_), {}, 0);
      return;
    }
    const Step first = downhill(cell_.middle, r, {}, 0.5, 0.5);
    const Candidate found =
        descend(cell_.shape, p_, {}, 0.5 + first.ds, 0.5 + first.dt, c, half_best());
    offer(found);
    if (std::max(found.lower, 0.0) < half_needed())
      split(distance_polynomial(cell_.shape, p_), {}, 0);
  }

  void settle(const Vec3& best_place) {
    Foot start;
    CellSearch(cell_, index_, best_place, start).run();
    offer(descend(cell_.shape, p_, {}, start.s, start.t, {},
                  std::numeric_limits<double>::infinity()));
  }

 private:
  /// Half the square of the best and what may be as near.
  double half_best() const { return (best_.squared + level_squared()) / 2; }
  /// What may be rounding in the difference of two squared distances like the best.
  double level_squared() const {
    const double far = std::sqrt(best_.squared);
    return 2 * far * kCoordinateRounding * (size_mm_ + far);
  }
  /// Half of the square of what is kFootTolerance_mm nearer than the best.
  double half_needed() const {
    return std::max(0.0, best_.squared / 2 - std::sqrt(best_.squared) * kFootTolerance_mm);
  }

  void offer(const Candidate& c) {
    const double level = level_squared();
    const bool first = best_.cell == Foot::kNone;
    if (c.squared > best_.squared + level || (first && c.squared >= best_.squared)) return;
    Foot foot{c.squared, index_, c.s, c.t};
    describe_hold(cell_, p_, foot);
    if (first || c.squared < best_.squared - level || more_surely(foot, best_)) best_ = foot;
  }

  /// Branch and bound where the Hessian may be indefinite.
  void split(const DistancePolynomial& f, const Window& w, int depth) {
    const double needed = half_needed();
    if (needed <= 0 || f.low() >= needed) return;
    const HessianRange h = hessian_range(f);
    const double size_s = w.s1 - w.s0, size_t = w.t1 - w.t0;
    Curvature c =
        least_curvature(h.uu_low, h.vv_low, std::max(std::abs(h.uv_low), std::abs(h.uv_high)));
    c = {c.ss / (size_s * size_s), c.tt / (size_t * size_t)};
    const auto lowest = std::min_element(f.c.begin(), f.c.end()) - f.c.begin();
    const double s = w.s0 + size_s * static_cast<double>(lowest % 7) / 6,
                 t = w.t0 + size_t * static_cast<double>(lowest / 7) / 6;
    const Candidate found = descend(cell_.shape, p_, w, s, t, c, needed);
    offer(found);
    if (found.lower >= half_needed() || depth >= kWindowHalvings) return;
    const bool in_s = std::max(std::abs(h.uu_low), std::abs(h.uu_high)) >=
                      std::max(std::abs(h.vv_low), std::abs(h.vv_high));
    // At the foot, if it is well inside: there the halves rise from their corner.
    const double foot = in_s ? (found.s - w.s0) / size_s : (found.t - w.t0) / size_t;
    const double at = foot > 0.05 && foot < 0.95 ? foot : 0.5;
    const auto parts = in_s ? split_u(f, at) : split_v(f, at);
    Window low = w, high = w;
    (in_s ? low.s1 : low.t1) = (in_s ? high.s0 : high.t0) =
        in_s ? w.s0 + size_s * at : w.t0 + size_t * at;
    const bool swap = parts[1].low() < parts[0].low();
    split(parts[swap ? 1 : 0], swap ? high : low, depth + 1);
    split(parts[swap ? 0 : 1], swap ? low : high, depth + 1);
  }

  const FootCell& cell_;
  std::uint32_t index_;
  const Vec3& p_;
  Foot& best_;
  double size_mm_;
};

}  // namespace

void nearer_in(const FootCell& cell, std::uint32_t index, const Vec3& p, Foot& best) {
  CellSearch(cell, index, p, best).run();
}

void settle_in(const FootCell& cell, std::uint32_t index, const Vec3& p, const Vec3& best_place,
               Foot& best) {
  CellSearch(cell, index, p, best).settle(best_place);
}

}  // namespace limitgauge::verifier
