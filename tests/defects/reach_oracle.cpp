#include "tests/defects/reach_oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/defects/nose.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

/// Clearances that count as free for sure, and that may: around the 1e-4 mm of CERTIFICATE.md.
constexpr double kSureContact_mm = 5e-5, kMaybeContact_mm = 2e-4;
/// Places of S nearer than a sample beside them by no more than this share of the spacing.
constexpr double kBetweenSamples = 1.0;
constexpr double kFinest_mm = 2e-5;
constexpr std::size_t kMostStarts = 10;

double distance_to(const simulator::CutterProfile& profile, double lift, const Vec3& tip,
                   const Vec3& p) {
  return profile.sample(std::hypot(p.x - tip.x, p.y - tip.y), p.z - tip.z - lift).distance;
}

}  // namespace

ReachOracle::Tool ReachOracle::tool_of(const model::Cutter& cutter, double above_mm) {
  const Nose nose(cutter, 0);
  Tool tool;
  tool.flat_mm = nose.flat(), tool.rounding_mm = nose.corner(), tool.wall_sine = nose.wall_sine();
  const simulator::CutterProfile flutes(cutter);
  tool.bodies.push_back({flutes, 0, flutes.largest_radius(), cutter.flute_length_mm});
  double lift = cutter.flute_length_mm, radius = flutes.largest_radius();
  for (const auto* parts : {&cutter.shank, &cutter.holder})
    for (const model::CylinderPart& part : *parts) {
      tool.neck = tool.neck || part.diameter_mm / 2 < flutes.largest_radius();
      radius = part.diameter_mm / 2;
      tool.bodies.push_back(
          {simulator::CutterProfile(radius, part.length_mm), lift, radius, lift + part.length_mm});
      lift += part.length_mm;
    }
  tool.bodies.push_back(
      {simulator::CutterProfile(radius, above_mm), lift, radius, lift + above_mm});
  return tool;
}

ReachOracle::ReachOracle(const SampledSurface& surface, std::span<const model::Cutter> cutters,
                         double allowance_mm)
    : surface_(surface), allowance_(allowance_mm) {
  const double above = length(surface.surface().bounding_box().size()) + 10;
  for (const model::Cutter& c : cutters) tools_.push_back(tool_of(c, above));
}

double ReachOracle::clearance(std::span<const Body> bodies, const Vec3& tip, double enough) const {
  const double slack = kBetweenSamples * surface_.spacing_mm();
  struct Seen {
    double value;
    const SampledSurface::Node* node;
  };
  const SampledSurface::Node* const first = surface_.nodes().data();
  const auto least_of = [&](const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Body& b : bodies) least = std::min(least, distance_to(b.profile, b.lift_mm, tip, p));
    return least;
  };
  double wide = 0, top = 0;
  for (const Body& b : bodies) wide = std::max(wide, b.radius_mm), top = std::max(top, b.top_mm);
  std::vector<Seen> seen;
  double best = enough;
  surface_.near_in_plan(tip.x, tip.y, wide + enough + slack, [&](const SampledSurface::Node& n) {
    if (n.point.z < tip.z - enough - slack || n.point.z > tip.z + top + enough + slack) return;
    const double value = least_of(n.point);
    if (value < enough + slack) seen.push_back({value, &n});
    best = std::min(best, value);
  });
  if (best < enough) return best;
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.value < b.value; });
  std::vector<const SampledSurface::Node*> starts;
  // Only from samples that no neighbour in their patch is nearer than.
  const auto lowest_around = [&](const Seen& s) {
    const SampledSurface::Grid& grid = surface_.grid_of(s.node->place.patch);
    const int n = grid.steps + 1, at = static_cast<int>(s.node - first - grid.first);
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        const int i = at % n + di, j = at / n + dj;
        if (i < 0 || j < 0 || i >= n || j >= n) continue;
        if (least_of(first[grid.first + j * n + i].point) < s.value - 1e-12) return false;
      }
    return true;
  };
  for (const Seen& s : seen) {
    if (starts.size() == kMostStarts) break;
    const bool near = std::any_of(starts.begin(), starts.end(), [&](const auto* o) {
      return o->place.patch == s.node->place.patch &&
             distance(o->point, s.node->point) < 3 * surface_.spacing_mm();
    });
    if (near || !lowest_around(s)) continue;
    starts.push_back(s.node);
    double found = 0;
    surface_.climb(
        s.node->place,
        [&](const Place&, const verifier::SurfaceSample& at) { return -least_of(at.position); },
        kFinest_mm, found);
    best = std::min(best, -found);
    if (best < enough) return best;
  }
  return best;
}

Reach ReachOracle::standing(const Tool& tool, const Vec3& tip, Reach least) const {
  const std::span<const Body> bodies = tool.bodies;
  if (clearance(bodies, tip, allowance_ - kSureContact_mm) >= allowance_ - kSureContact_mm)
    return Reach::sure;
  if (least == Reach::sure) return Reach::no;
  const double may = allowance_ - kMaybeContact_mm;
  return clearance(bodies.first(1), tip, may) >= may ? Reach::maybe : Reach::no;
}

/// Between walls one position of a flat may be free, or a line of them: where the clearance is
/// most, from several starts by ever smaller steps.
Reach ReachOracle::widest(const Tool& tool, const Vec3& core) const {
  constexpr int kStarts = 8, kWays = 8;
  const std::span<const Body> flutes(tool.bodies.data(), 1);
  const double may = allowance_ - kMaybeContact_mm;
  const auto within = [&](Vec3 offset) {
    const double out = std::hypot(offset.x, offset.y);
    return out > tool.flat_mm ? offset * (tool.flat_mm / out) : offset;
  };
  for (int start = 0; start < kStarts; ++start) {
    const double from = 2 * std::numbers::pi * start / kStarts;
    Vec3 at = Vec3{std::cos(from), std::sin(from), 0} * (0.7 * tool.flat_mm);
    double value = clearance(flutes, core + at, may);
    for (double step = tool.flat_mm / 2; step > kFinest_mm && value < may;) {
      Vec3 best = at;
      for (int k = 0; k < kWays; ++k) {
        const double way = 2 * std::numbers::pi * (k + 0.3 * start) / kWays;
        const Vec3 tried = within(at + Vec3{std::cos(way), std::sin(way), 0} * step);
        const double here = clearance(flutes, core + tried, may);
        if (here > value) value = here, best = tried;
      }
      if (best == at) step /= 2;
      at = best;
    }
    if (value >= may && standing(tool, core + at, Reach::maybe) != Reach::no) return Reach::maybe;
  }
  return Reach::no;
}

Reach ReachOracle::with(const Tool& tool, const Vec3& point, const Vec3& normal,
                        Reach least) const {
  constexpr double kLevel = 1e-9, kRounding = 1e-10, kSteep = 1e-6;
  constexpr int kTurns = 16, kRings = 3;
  // The upper side of a cutter with a neck may touch, too: left open here.
  if (normal.z < tool.wall_sine - kSteep) return tool.neck ? Reach::maybe : Reach::no;
  const Vec3 core = point + normal * (tool.rounding_mm + allowance_) - Vec3{0, 0, tool.rounding_mm};
  const double level = std::hypot(normal.x, normal.y);
  Reach best = Reach::no;
  if (tool.flat_mm == 0 || level > kLevel) {
    const double out = tool.flat_mm == 0 ? 0 : tool.flat_mm / level;
    best = standing(tool, core + Vec3{normal.x * out, normal.y * out, 0}, least);
  } else {
    best = standing(tool, core, least);
    for (int k = 0; k < kTurns * kRings && best != Reach::sure; ++k) {
      const double angle = 2 * std::numbers::pi * k / kTurns,
                   out = tool.flat_mm * (1 + k / kTurns) / kRings;
      best = std::max(
          best,
          standing(tool, core + Vec3{out * std::cos(angle), out * std::sin(angle), 0}, least));
    }
    if (best == Reach::no && least != Reach::sure) best = widest(tool, core);
  }
  return normal.z < tool.wall_sine - kRounding ? std::min(best, Reach::maybe) : best;
}

Reach ReachOracle::at(const Vec3& point, const Vec3& normal, Reach least) const {
  Reach best = Reach::no;
  for (const Tool& tool : tools_) {
    best = std::max(best, with(tool, point, normal, least));
    if (best == Reach::sure) break;
  }
  return best;
}

}  // namespace limitgauge::tests::defects
