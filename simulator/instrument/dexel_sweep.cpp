#include "simulator/instrument/dexel_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/sweep/vector_loops.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

DexelSweep::DexelSweep(const DexelProfile& profile, const Vec3& from, const Vec3& to)
    : profile_(&profile),
      start_(from),
      end_(to),
      end_z_(to.z),
      tip_low_(std::min(from.z, to.z)),
      tip_high_(std::max(from.z, to.z)) {
  const double run = model::level_distance(from, to);
  if (run < kLeastRun_mm) return;
  run_ = run, slope_ = (to.z - from.z) / run;
  along_x_ = (to.x - from.x) / run, along_y_ = (to.y - from.y) / run;
}

std::optional<DexelSweep::Reach> DexelSweep::reach(double along, double across) const {
  const double r = profile_->largest_radius();
  if (!(std::abs(across) <= r)) return {};
  const double half = std::sqrt((r - across) * (r + across));
  const Reach reach{std::max(0.0, along - half), std::min(run_, along + half)};
  if (reach.first > reach.last) return {};
  return reach;
}

// `side` is the height under the cutter, or minus that above it, at each radius. With the tip's
// fall (or rise) along the move it makes a convex function of the place s, smallest at the nearest
// place and `foot` further on.
double DexelSweep::best_place(const ConvexMeridian& side, double toward, double along,
                              double across, const Reach& reach) const {
  const double slope = std::abs(slope_), v = std::abs(across);
  const double begin = toward > 0 ? reach.first : reach.last;
  const double end = toward > 0 ? reach.last : reach.first;
  const double w0 = toward * (begin - along), w1 = toward * (end - along);
  // Short moves are done with a look at their ends.
  if (w1 <= 0 || !side.steeper(radius(w1, v), w1, slope)) return end;
  if (w0 >= 0 && side.steeper(radius(w0, v), w0, slope)) return begin;
  return std::clamp(along + toward * side.foot(v, slope), reach.first, reach.last);
}

double DexelSweep::radius(double along, double across) const {
  return std::min(std::sqrt(along * along + across * across), profile_->largest_radius());
}

double DexelSweep::lowest(double along, double across, const Reach& reach) const {
  const ConvexMeridian& side = profile_->lower();
  const double s = best_place(side, slope_ < 0 ? 1 : -1, along, across, reach);
  return tip_z(s) + side.height(radius(along - s, across));
}

double DexelSweep::highest(double along, double across, const Reach& reach) const {
  const ConvexMeridian& side = profile_->minus_upper();
  const double s = best_place(side, slope_ < 0 ? -1 : 1, along, across, reach);
  return tip_z(s) - side.height(radius(along - s, across));
}

std::optional<model::Interval> DexelSweep::interval(double x, double y) const {
  if (vertical()) {
    const double rho = std::hypot(x - start_.x, y - start_.y);
    if (!(rho <= profile_->largest_radius())) return {};
    return model::Interval{tip_low_ + profile_->lower().height(rho),
                           tip_high_ - profile_->minus_upper().height(rho)};
  }
  const double u = along(x, y), v = across(x, y);
  const auto places = reach(u, v);
  if (!places) return {};
  return model::Interval{lowest(u, v, *places), highest(u, v, *places)};
}

// The lowest point of a swept sphere over a line. Without branches, for the compiler to take
// several lines at once.
struct DexelSweep::BallEnd {
  double r2, slope, share, run, base;

  double operator()(double along, double across) const {
    const double inside = r2 - across * across;
    double s = along - share * std::sqrt(inside < 0 ? 0 : inside);
    s = s < 0 ? 0 : s;
    s = s > run ? run : s;
    const double w = along - s, h = inside - w * w;
    const double z = base + slope * s - std::sqrt(h < 0 ? 0 : h);
    return h < 0 ? kInfinity : z;
  }
};

DexelSweep::BallEnd DexelSweep::ball_end() const {
  const double r = profile_->largest_radius();
  return {r * r, slope_, slope_ / std::sqrt(1 + slope_ * slope_), run_,
          (vertical() ? tip_low_ : start_.z) + r};
}

LIMITGAUGE_WIDE
void DexelSweep::ball_ends(double x, double y, double step_x, double step_y, double* low) const {
  const BallEnd end = ball_end();
  const double ax = along_x_, ay = along_y_, x0 = x - start_.x, y0 = y - start_.y;
  for (int j = 0; j < kSquare; ++j) {
    const double py = y0 + j * step_y;
    for (int i = 0; i < kSquare; ++i) {
      const double px = x0 + i * step_x;
      low[j * kSquare + i] = end(px * ax + py * ay, py * ax - px * ay);
    }
  }
}

void DexelSweep::lower_ends(double x, double y, double step, int n, const double* standing,
                            double* low) const {
  if (profile_->is_ball()) {
    const BallEnd end = ball_end();
    for (int i = 0; i < n; ++i) low[i] = end(along(x + i * step, y), across(x + i * step, y));
    return;
  }
  const ConvexMeridian& lower = profile_->lower();
  const double r = profile_->largest_radius();
  for (int i = 0; i < n; ++i) {
    const double u = along(x + i * step, y), v = across(x + i * step, y);
    const double over = u - std::clamp(u, 0.0, run_), nearest = std::sqrt(over * over + v * v);
    low[i] = kInfinity;
    if (!(nearest <= r)) continue;
    // From anywhere on the move the line is no nearer and the tip no lower.
    const double bound = tip_low_ + lower.height(nearest);
    if (bound >= standing[i]) continue;
    if (slope_ == 0)
      low[i] = bound;
    else if (const auto places = reach(u, v))
      low[i] = lowest(u, v, *places);
  }
}

model::Interval DexelSweep::span(double y_low, double y_high) const {
  const double r = profile_->largest_radius();
  // Of the segment only what is within a radius of the band can reach it.
  double from = 0, to = 1;
  const double dy = end_.y - start_.y;
  if (dy != 0) {
    const double a = (y_low - r - start_.y) / dy, b = (y_high + r - start_.y) / dy;
    from = std::max(0.0, std::min(a, b)), to = std::min(1.0, std::max(a, b));
  } else if (start_.y < y_low - r || start_.y > y_high + r) {
    return model::Interval::none();
  }
  model::Interval span = model::Interval::none();
  if (from > to) return span;
  for (const double t : {from, to}) {
    const double x = start_.x + t * (end_.x - start_.x);
    span.add(model::Interval{x - r, x + r});
  }
  return span;
}

// From anywhere on the move no line of the rectangle is nearer, and the tip is no lower.
double DexelSweep::level_clearance(const DexelPlanes& p, std::size_t k) const {
  const double u = along(p.x[k], p.y[k]), v = across(p.x[k], p.y[k]);
  const double over = u - std::clamp(u, 0.0, run_);
  const double half = std::sqrt(p.half_x * p.half_x + p.half_y * p.half_y);
  const double nearest = std::max(0.0, std::sqrt(over * over + v * v) - half);
  if (nearest > profile_->largest_radius()) return kInfinity;
  const double highest =
      p.height[k] + std::abs(p.slope_x[k]) * p.half_x + std::abs(p.slope_y[k]) * p.half_y;
  return tip_low_ + profile_->lower().height(nearest) - highest;
}

// The lower side is convex and lies above its tangent; beyond kSteep of the radius that is too
// steep to be of use, and the bound is that of the nearest line.
LIMITGAUGE_WIDE
void DexelSweep::ball_clearances(const DexelPlanes& p, std::size_t n, double* clear) const {
  constexpr double kSteep = 0.97;
  const double r = profile_->largest_radius(), r2 = r * r, least = (1 - kSteep * kSteep) * r2;
  const double k = slope_, share = k / std::sqrt(1 + k * k), run = run_;
  const double ax = along_x_, ay = along_y_, x0 = start_.x, y0 = start_.y;
  const double low = tip_low_ + r, base = (vertical() ? tip_low_ : start_.z) + r;
  const double hx = p.half_x, hy = p.half_y, half = std::sqrt(hx * hx + hy * hy);
  LIMITGAUGE_EACH
  for (std::size_t i = 0; i < n; ++i) {
    const double x = p.x[i] - x0, y = p.y[i] - y0;
    const double u = x * ax + y * ay, v = y * ax - x * ay, inside = r2 - v * v;
    double s = u - share * std::sqrt(inside < 0 ? 0 : inside);
    s = s < 0 ? 0 : s;
    s = s > run ? run : s;
    const double w = u - s, h = inside - w * w;
    const double root = std::sqrt(h < least ? least : h), inverse = 1 / root;
    const double gu = w * inverse, gv = v * inverse;
    const double tilt_x = gu * ax - gv * ay - p.slope_x[i],
                 tilt_y = gu * ay + gv * ax - p.slope_y[i];
    const double tangent =
        base + k * s - root - p.height[i] - std::abs(tilt_x) * hx - std::abs(tilt_y) * hy;
    double t = u < 0 ? 0 : u;
    t = t > run ? run : t;
    const double over = u - t, away = std::sqrt(over * over + v * v) - half;
    const double below = r2 - (away < 0 ? 0 : away * away);
    const double rim = low - std::sqrt(below < 0 ? 0 : below) - p.height[i] -
                       std::abs(p.slope_x[i]) * hx - std::abs(p.slope_y[i]) * hy;
    const double reached = h >= least && tangent > rim ? tangent : rim;
    clear[i] = below < 0 ? kInfinity : reached;
  }
}

void DexelSweep::clearances(const DexelPlanes& planes, std::size_t n, double* clear) const {
  if (profile_->is_ball()) return ball_clearances(planes, n, clear);
  for (std::size_t k = 0; k < n; ++k) clear[k] = level_clearance(planes, k);
}

}  // namespace limitgauge::simulator
