#include "simulator/process/fixture_check.h"

#include <algorithm>

#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

// How finely the least distance over a fixture is looked for.
constexpr double kPrecisionInTolerances = 1.0 / 16;

bool apart(const Box3& a, const Box3& b) {
  return common(a, b).empty();
}

// Where a tip may be when a body comes within `near` of `target`.
Box3 tips_near(const Box3& target, const std::vector<ToolBody>& bodies, double near) {
  Box3 tips;
  for (const ToolBody& body : bodies) {
    Box3 box = target.grown(near);
    const double r = body.profile.largest_radius();
    box.low -= Vec3{r, r, body.base_mm + body.profile.length()};
    box.high += Vec3{r, r, -body.base_mm};
    tips.add(box);
  }
  return tips;
}

}  // namespace

FixtureCheck::FixtureCheck(const std::vector<model::Fixture>& fixtures, const Pass& pass,
                           const ToolBodies& bodies, const StockLimits& limits)
    : path_(*pass.path), assembly_(bodies), bodies_(bodies.parts()), limits_(limits) {
  Box3 all;
  if (!path_.moves.empty()) all.add(path_.start);
  for (const model::Move& m : path_.moves) all.add(m.to);
  for (const model::Fixture& fixture : fixtures) {
    FixtureSolid solid(fixture.mesh);
    const Box3 tips = tips_near(solid.box(), bodies_, limits.near_miss_mm);
    if (!apart(tips, all)) obstacles_.push_back({fixture.name, std::move(solid), tips});
  }
}

void FixtureCheck::look_at(std::size_t move, std::vector<Finding>& findings) const {
  if (obstacles_.empty()) return;
  const SweptMove tip(move_from(path_, move), path_.moves[move].to,
                      static_cast<std::uint32_t>(move));
  for (const Obstacle& obstacle : obstacles_) {
    if (apart(obstacle.tips, tip_box(tip))) continue;
    for (const ToolBody& body : bodies_) look_at(obstacle, body, move, tip, findings);
    look_at_joined(obstacle, move, tip, findings);
  }
}

const char* FixtureCheck::part_there(const ToolBody& body, const SweptMove& tip,
                                     const Vec3& p) const {
  const double t = swept_distance(body.profile, body.of_tip(tip), p).t;
  return name(assembly_.part_at(p.z - (tip.start.z + t * tip.delta.z)));
}

void FixtureCheck::look_at_joined(const Obstacle& obstacle, std::size_t i, const SweptMove& tip,
                                  std::vector<Finding>& findings) const {
  const double tolerance = limits_.tolerance_mm;
  for (const ToolBody& body : assembly_.joined) {
    const SweptMove own = body.of_tip(tip);
    if (apart(swept_box(body.profile, own), obstacle.solid.box())) continue;
    const auto place =
        obstacle.solid.nearest(body.profile, own, 0, tolerance * kPrecisionInTolerances);
    if (place && place->distance < -tolerance)
      findings.push_back({FindingKind::fixture_touched, i, path_.moves[i].line, place->point,
                          -place->distance, part_there(body, tip, place->point), obstacle.name});
  }
}

void FixtureCheck::look_at(const Obstacle& obstacle, const ToolBody& body, std::size_t i,
                           const SweptMove& tip, std::vector<Finding>& findings) const {
  const SweptMove own = body.of_tip(tip);
  const Box3 box = swept_box(body.profile, own);
  const double near = limits_.near_miss_mm, tolerance = limits_.tolerance_mm;
  if (apart(box.grown(near), obstacle.solid.box())) return;
  const auto found = [&](FindingKind kind, const Vec3& point, double depth) {
    findings.push_back(
        {kind, i, path_.moves[i].line, point, depth, name(body.part), obstacle.name});
  };
  const double precision = tolerance * kPrecisionInTolerances;
  const auto place = obstacle.solid.nearest(body.profile, own, near, precision);
  if (place && place->distance < -tolerance)
    return found(FindingKind::fixture_touched, place->point, -place->distance);
  // A body that the surface does not cut is wholly inside or wholly outside.
  const Vec3 within = own.start + Vec3{0, 0, body.profile.length() / 2};
  if (obstacle.solid.box().contains(within) && obstacle.solid.encloses(within)) {
    const double inside = swept_distance(body.profile, own, within).distance;
    const auto wall = obstacle.solid.nearest(body.profile, own,
                                             std::numeric_limits<double>::infinity(), precision);
    return found(FindingKind::fixture_touched, wall->point, wall->distance - inside);
  }
  if (place && place->distance < -limits_.slightest_mm())
    return found(FindingKind::slight_contact, place->point, -place->distance);
  if (place && near > 0)
    found(FindingKind::near_miss, place->point, -std::max(0.0, place->distance));
}

}  // namespace limitgauge::simulator
