#include "simulator/instrument/dexel_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// The lowest point of a swept sphere over each line. Without branches, for the compiler to take
// several lines at once.
void DexelSweep::ball_ends(double x, double y, double step, int n, double* low) const {
  const double r = profile_->largest_radius(), r2 = r * r;
  const double k = slope_, share = k / std::sqrt(1 + k * k), run = run_;
  const double u0 = along(x, y), v0 = across(x, y);
  const double du = step * along_x_, dv = -step * along_y_;
  const double base = (vertical() ? tip_low_ : start_.z) + r;
  for (int i = 0; i < n; ++i) {
    const double u = u0 + i * du, v = v0 + i * dv, inside = r2 - v * v;
    double s = u - share * std::sqrt(inside < 0 ? 0 : inside);
    s = s < 0 ? 0 : s;
    s = s > run ? run : s;
    const double w = u - s, h = inside - w * w;
    const double z = base + k * s - std::sqrt(h < 0 ? 0 : h);
    low[i] = h < 0 ? kInfinity : z;
  }
}

void DexelSweep::lower_ends(double x, double y, double step, int n, const double* standing,
                            double* low) const {
  if (profile_->is_ball()) return ball_ends(x, y, step, n, low);
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

model::Interval DexelSweep::row(double y) const {
  const double r = profile_->largest_radius();
  model::Interval span = model::Interval::none();
  for (const Vec3* centre : {&start_, &end_}) {
    const double d = y - centre->y;
    if (std::abs(d) > r) continue;
    const double half = std::sqrt((r - d) * (r + d));
    span.add(model::Interval{centre->x - half, centre->x + half});
  }
  // Between the ends: |across| <= r and 0 <= along <= run.
  if (vertical() || along_y_ == 0) return span;
  const double d = y - start_.y;
  const double a = (d * along_x_ - r) / along_y_, b = (d * along_x_ + r) / along_y_;
  double from = std::min(a, b), to = std::max(a, b);
  if (along_x_ != 0) {
    const double p = -d * along_y_ / along_x_, q = (run_ - d * along_y_) / along_x_;
    from = std::max(from, std::min(p, q)), to = std::min(to, std::max(p, q));
  } else if (d * along_y_ < 0 || d * along_y_ > run_) {
    return span;
  }
  if (from <= to) span.add(model::Interval{start_.x + from, start_.x + to});
  return span;
}

double DexelSweep::least_lower(double y) const {
  const double off =
      std::max({0.0, std::min(start_.y, end_.y) - y, y - std::max(start_.y, end_.y)});
  if (off > profile_->largest_radius()) return kInfinity;
  return tip_low_ + profile_->lower().height(off);
}

}  // namespace limitgauge::simulator
