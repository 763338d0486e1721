#include "tests/defects/surfaces/sampled_surface.h"

#include <algorithm>
#include <numbers>

#include "verifier/surface/surface_tree.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;
using verifier::SurfaceSample;

constexpr double kBin_mm = 0.5;
constexpr double kNone = -std::numeric_limits<double>::infinity();
/// The height found is lower than the contact by the square of this over a radius of curvature.
constexpr double kFinestContact_mm = 1.5e-4;
/// A start that lies lower than a contact found by more than this is not worth the climb.
constexpr double kHopeless_mm = 0.1;
/// A sample beside the contact lies lower than it by no more than this: steps of 0.12 mm on slopes
/// that reach 2, at the edge of a flat.
constexpr double kSlack_mm = 0.25;
/// A step must gain this much of its square, in mm, lest a search creeps.
constexpr double kLeastGain = 0.003;
constexpr std::size_t kMostStarts = 8;
constexpr double kApart_mm = 0.4;

/// Steps along a patch so that no step of its net is longer than the spacing.
int steps_for(const verifier::ReferenceSurface& surface, int patch, double spacing_mm) {
  constexpr int kProbe = 8;
  double longest = 0;
  for (int j = 0; j <= kProbe; ++j)
    for (int i = 0; i < kProbe; ++i) {
      const double a = static_cast<double>(i) / kProbe, b = static_cast<double>(i + 1) / kProbe,
                   c = static_cast<double>(j) / kProbe;
      longest = std::max(
          {longest,
           distance(surface.evaluate(patch, a, c).position, surface.evaluate(patch, b, c).position),
           distance(surface.evaluate(patch, c, a).position,
                    surface.evaluate(patch, c, b).position)});
    }
  return std::max(4, static_cast<int>(std::ceil(longest * kProbe / spacing_mm)));
}

double safe_ratio(double step_mm, double speed) {
  return speed > 1e-9 ? std::min(0.5, step_mm / speed) : 0.5;
}

}  // namespace

SampledSurface::SampledSurface(const verifier::ReferenceSurface& surface, double spacing_mm)
    : surface_(surface), spacing_(spacing_mm), grid_of_(surface.patch_count(), -1) {
  for (int patch = 0; patch < surface.patch_count(); ++patch) {
    if (!surface.has_surface(patch)) continue;
    const int n = steps_for(surface, patch, spacing_mm);
    grid_of_[patch] = static_cast<int>(grids_.size());
    grids_.push_back({patch, nodes_.size(), n});
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const Place place{patch, static_cast<double>(i) / n, static_cast<double>(j) / n};
        const SurfaceSample s = at(place);
        nodes_.push_back({place, s.position, s.normal});
        box_.add(s.position);
      }
  }
  fill_bins();
}

void SampledSurface::fill_bins() {
  const Vec3 size = box_.size();
  bins_x_ = static_cast<int>(size.x / kBin_mm) + 1;
  bins_y_ = static_cast<int>(size.y / kBin_mm) + 1;
  bins_.resize(static_cast<std::size_t>(bins_x_) * bins_y_);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Vec3& p = nodes_[k].point;
    const int i = std::min(bins_x_ - 1, static_cast<int>((p.x - box_.low.x) / kBin_mm));
    const int j = std::min(bins_y_ - 1, static_cast<int>((p.y - box_.low.y) / kBin_mm));
    Bin& bin = bins_[static_cast<std::size_t>(j) * bins_x_ + i];
    bin.highest = std::max(bin.highest, p.z);
    bin.nodes.push_back(static_cast<std::uint32_t>(k));
  }
}

std::pair<int, int> SampledSurface::bin_range(double from, double at, double radius, int count) {
  const auto bin = [&](double to) {
    return std::clamp(static_cast<int>(std::floor((to - from) / kBin_mm)), 0, count - 1);
  };
  return {bin(at - radius), bin(at + radius)};
}

/// The best samples under the nose, some way from each other.
std::vector<SampledSurface::Seen> SampledSurface::starts(const Nose& nose, double x,
                                                         double y) const {
  const double reach = nose.radius_below(box_.size().z);
  const auto bin_of = [](double from, double to, int count) {
    return std::clamp(static_cast<int>(std::floor((to - from) / kBin_mm)), 0, count - 1);
  };
  struct Bound {
    double value;
    const Bin* bin;
  };
  std::vector<Bound> bounds;
  for (int j = bin_of(box_.low.y, y - reach, bins_y_); j <= bin_of(box_.low.y, y + reach, bins_y_);
       ++j)
    for (int i = bin_of(box_.low.x, x - reach, bins_x_);
         i <= bin_of(box_.low.x, x + reach, bins_x_); ++i) {
      const Bin& bin = bins_[static_cast<std::size_t>(j) * bins_x_ + i];
      const double bx = box_.low.x + i * kBin_mm, by = box_.low.y + j * kBin_mm;
      const double dx = std::max({bx - x, 0.0, x - bx - kBin_mm}),
                   dy = std::max({by - y, 0.0, y - by - kBin_mm});
      const double bound = bin.highest - nose.height(std::hypot(dx, dy));
      if (bound > kNone) bounds.push_back({bound, &bin});
    }
  std::sort(bounds.begin(), bounds.end(),
            [](const Bound& a, const Bound& b) { return a.value > b.value; });
  double best = kNone;
  std::vector<Seen> seen;
  for (const Bound& b : bounds) {
    if (b.value < best - kSlack_mm) break;
    for (const std::uint32_t k : b.bin->nodes) {
      const Vec3& p = nodes_[k].point;
      const double value = p.z - nose.height(std::hypot(p.x - x, p.y - y));
      if (value == kNone || !(value >= best - kSlack_mm)) continue;
      best = std::max(best, value);
      seen.push_back({value, k});
    }
  }
  std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
    return a.value != b.value ? a.value > b.value : a.node < b.node;
  });
  std::vector<Seen> out;
  for (const Seen& s : seen) {
    if (s.value < best - kSlack_mm || out.size() == kMostStarts) break;
    const bool near = std::any_of(out.begin(), out.end(), [&](const Seen& o) {
      // A neighbouring patch has a start of its own: the search does not cross its rim.
      return nodes_[o.node].place.patch == nodes_[s.node].place.patch &&
             distance(nodes_[o.node].point, nodes_[s.node].point) < kApart_mm;
    });
    if (!near) out.push_back(s);
  }
  return out;
}

/// The sample at `place`, moved in plan onto the wall of the cutter where it lies beyond it, so
/// that a search can slide along the wall; none where that does not succeed.
std::optional<SurfaceSample> SampledSurface::pulled_in(Place& place, double x, double y,
                                                       double wall) const {
  constexpr double kInside_mm = 1e-10;
  constexpr int kMostSteps = 6;
  for (int step = 0; step < kMostSteps; ++step) {
    const SurfaceSample s = at(place);
    const double dx = s.position.x - x, dy = s.position.y - y, rho = std::hypot(dx, dy);
    if (rho <= wall) return s;
    // Newton's step for the radius, along its gradient in u and v; along the rim of the patch where
    // that would leave it.
    const double over = rho - wall + kInside_mm;
    double gu = (s.du.x * dx + s.du.y * dy) / rho, gv = (s.dv.x * dx + s.dv.y * dy) / rho;
    if ((place.u == 0 && gu > 0) || (place.u == 1 && gu < 0)) gu = 0;
    if ((place.v == 0 && gv > 0) || (place.v == 1 && gv < 0)) gv = 0;
    const double steep = gu * gu + gv * gv;
    if (steep < 1e-12) return std::nullopt;
    place.u = std::clamp(place.u - over * gu / steep, 0.0, 1.0);
    place.v = std::clamp(place.v - over * gv / steep, 0.0, 1.0);
  }
  return std::nullopt;
}

void SampledSurface::climb_on_nose(const Nose& nose, double x, double y, Touch& touch) const {
  SurfaceSample here = at(touch.place);
  double step = 0.7 * spacing_;
  while (step > kFinestContact_mm) {
    const double su = safe_ratio(step, length(here.du)), sv = safe_ratio(step, length(here.dv));
    bool better = false;
    for (int k = 0; k < 8 && !better; ++k) {
      constexpr int kU[] = {1, 0, -1, 0, 1, -1, -1, 1}, kV[] = {0, 1, 0, -1, 1, 1, -1, -1};
      Place trial{touch.place.patch, std::clamp(touch.place.u + kU[k] * su, 0.0, 1.0),
                  std::clamp(touch.place.v + kV[k] * sv, 0.0, 1.0)};
      const auto s = pulled_in(trial, x, y, nose.wall());
      if (!s) continue;
      const double rho = std::hypot(s->position.x - x, s->position.y - y);
      const double value = s->position.z - nose.height(rho);
      if (value > touch.tip_z + kLeastGain * step * step)
        touch = {value, trial, rho}, here = *s, better = true;
    }
    if (!better) step /= 2;
  }
}

std::optional<Touch> SampledSurface::drop(const Nose& nose, double x, double y) const {
  std::optional<Touch> best;
  for (const Seen& s : starts(nose, x, y)) {
    if (best && s.value < best->tip_z - kHopeless_mm) break;
    const Node& node = nodes_[s.node];
    Touch touch{s.value, node.place, std::hypot(node.point.x - x, node.point.y - y)};
    climb_on_nose(nose, x, y, touch);
    if (!best || touch.tip_z > best->tip_z) best = touch;
  }
  return best;
}

bool SampledSurface::is_on_rim(const Place& p) const {
  constexpr double kOnSide = 1e-6;
  const auto& sides = surface_.tree().features().of(p.patch).sides;
  const double from[4] = {p.v, 1 - p.u, 1 - p.v, p.u};
  for (int k = 0; k < 4; ++k)
    if (from[k] <= kOnSide && sides[k] == verifier::SurfaceFeature::boundary) return true;
  return false;
}

Place SampledSurface::climb(const Place& start, const Field& field, double finest_mm,
                            double& value) const {
  Place place = start;
  SurfaceSample here = at(place);
  value = field(place, here);
  double turn = 0;
  for (double step = spacing_; step > finest_mm;) {
    const double su = safe_ratio(step, length(here.du)), sv = safe_ratio(step, length(here.dv));
    bool better = false;
    for (int k = 0; k < 8 && !better; ++k) {
      const double angle = turn + k * std::numbers::pi / 4;
      const Place trial{place.patch, std::clamp(place.u + su * std::cos(angle), 0.0, 1.0),
                        std::clamp(place.v + sv * std::sin(angle), 0.0, 1.0)};
      const SurfaceSample s = at(trial);
      const double found = field(trial, s);
      if (found > value + kLeastGain * step * step)
        value = found, place = trial, here = s, better = true;
    }
    // An irrational part of a turn: on a ridge some direction runs along it sooner or later.
    turn += better ? 0 : std::numbers::phi;
    if (!better) step *= 0.6;
  }
  return place;
}

}  // namespace limitgauge::tests::defects
