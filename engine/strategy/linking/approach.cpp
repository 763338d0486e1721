#include "engine/strategy/linking/approach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

/// Radius of lead arcs as a share of the cutter's radius, and how they are made of chords.
constexpr double kLeadShare = 0.25;
constexpr int kLeadChords = 6;
/// Passes whose first chord rises by less than this share of it count as level.
constexpr double kLevel = 0.02;

Vec3 level_left(const Vec3& way) {
  return normalized(Vec3{-way.y, way.x, 0});
}

/// A quarter circle that arrives at `at` along `way`, bending towards it from the side `from`.
std::vector<Vec3> arc_into(const Vec3& at, const Vec3& way, const Vec3& from, double radius) {
  std::vector<Vec3> tips;
  for (int i = kLeadChords; i > 0; --i) {
    const double angle = std::numbers::pi / 2 * i / kLeadChords;
    tips.push_back(at - way * (radius * std::sin(angle)) + from * (radius * (1 - std::cos(angle))));
  }
  tips.push_back(at);
  return tips;
}

/// Lead into the first of `tips`: from the side where the pass is level, else from above.
std::optional<std::vector<Vec3>> lead_into(const ApproachRule& rule,
                                           const std::vector<Vec3>& tips) {
  if (tips.size() < 2) return std::nullopt;
  const Vec3 way = normalized(tips[1] - tips[0]), left = level_left(way);
  if (left == Vec3{}) return std::nullopt;
  const Vec3 up = cross(way, left) * -1;
  const Vec3 above = up.z < 0 ? -up : up;
  std::array<Vec3, 3> sides = {left, -left, above};
  if (std::abs(way.z) > kLevel) sides = {above, left, -left};
  const double slack = rule.slack_at(tips.front());
  for (const Vec3& side : sides) {
    auto arc = arc_into(tips.front(), way, side, kLeadShare * rule.request.cutter.radius_mm());
    if (rule.clears(arc, slack)) return arc;
  }
  return std::nullopt;
}

}  // namespace

double ApproachRule::slack_at(const Vec3& tip) const {
  const auto z = locations.tip_z(tip.x, tip.y);
  return z ? std::max(0.0, *z - tip.z) : 0.0;
}

bool ApproachRule::clears(const std::vector<Vec3>& tips, double slack_mm) const {
  for (std::size_t i = 1; i < tips.size(); ++i)
    if (!locations.clears(tips[i - 1], tips[i], slack_mm)) return false;
  return true;
}

Approach way_in(const ApproachRule& rule, const CutPass& pass, const std::vector<Vec3>& tips) {
  const double stands = pass.stands_to_mm.value_or(tips.front().z);
  if (stands <= tips.front().z) {
    if (auto lead = lead_into(rule, tips)) return {std::move(*lead), false, false};
    return {{tips.front()}, false, false};
  }
  const double depth = stands + rule.air_mm - tips.front().z;
  const Entry entry = rule.request.cut.entry;
  std::optional<std::vector<Vec3>> way;
  if (entry == Entry::helix) way = helix_to(rule, tips, depth);
  if (!way && entry != Entry::plunge) way = ramp_along(rule, tips, depth);
  if (way) return {std::move(*way), true, true};
  return {{tips.front() + Vec3{0, 0, depth}, tips.front()}, true, true};
}

Approach way_out(const ApproachRule& rule, const std::vector<Vec3>& tips) {
  std::vector<Vec3> back(tips.rbegin(),
                         tips.rbegin() + std::min<std::ptrdiff_t>(2, std::ssize(tips)));
  auto lead = lead_into(rule, back);
  if (!lead) return {{tips.back()}, false, false};
  std::reverse(lead->begin(), lead->end());
  return {std::move(*lead), false, false};
}

}  // namespace limitgauge::engine::strategy
