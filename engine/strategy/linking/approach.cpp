#include "engine/strategy/linking/approach.h"
#include "engine/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/base/angle.h"

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

namespace {

using model::Vec3;

/// Longest leg of a zigzag of ramps, in cutter diameters, and the shortest worth a ramp.
constexpr double kLongestLeg = 3, kShortestLeg = 0.05;
/// Largest radius of a helix as a share of the cutter's: no core is left standing.
constexpr double kHelixShare = 0.4, kSmallestHelixShare = 0.1;
constexpr int kHelixChords = 24;

double steepest(const ApproachRule& rule) {
  return kFlatter * std::tan(model::radians(rule.request.cut.ramp_angle_deg));
}

/// The first `length` mm, as seen from above, of a polyline.
std::vector<Vec3> beginning(const std::vector<Vec3>& tips, double length) {
  std::vector<Vec3> part = {tips.front()};
  for (std::size_t i = 1; i < tips.size() && length > 0; ++i) {
    const double step = level_distance(tips[i - 1], tips[i]);
    if (step <= 0) continue;
    part.push_back(step <= length ? tips[i] : lerp(tips[i - 1], tips[i], length / step));
    length -= step;
  }
  return part;
}

double level_length(const std::vector<Vec3>& tips) {
  double length = 0;
  for (std::size_t i = 1; i < tips.size(); ++i) length += level_distance(tips[i - 1], tips[i]);
  return length;
}

/// To and fro over `leg`, ending at its first tip: written from there backwards, upwards.
std::vector<Vec3> zigzag_over(const std::vector<Vec3>& leg, int legs, double rise_by_mm) {
  std::vector<Vec3> way = {leg.front()};
  const int last = static_cast<int>(leg.size()) - 1;
  for (int k = 0; k < legs; ++k)
    for (int i = 1; i <= last; ++i) {
      const Vec3& to = k % 2 == 0 ? leg[i] : leg[last - i];
      const double z = way.back().z + rise_by_mm * level_distance(way.back(), to);
      way.push_back({to.x, to.y, z});
    }
  std::reverse(way.begin(), way.end());
  return way;
}

/// Helix about `centre` that ends at `end` after turning by `turn` (radians, signed).
std::vector<Vec3> helix(const Vec3& centre, const Vec3& end, double depth_mm, double turn,
                        int chords) {
  std::vector<Vec3> way;
  const double x = end.x - centre.x, y = end.y - centre.y;
  for (int i = chords; i > 0; --i) {
    const double back = -turn * i / chords, c = std::cos(back), s = std::sin(back);
    way.push_back(
        {centre.x + c * x - s * y, centre.y + s * x + c * y, end.z + depth_mm * i / chords});
  }
  way.push_back(end);
  return way;
}

}  // namespace

std::optional<std::vector<Vec3>> ramp_along(const ApproachRule& rule, const std::vector<Vec3>& tips,
                                            double depth_mm) {
  const double diameter = 2 * rule.request.cutter.radius_mm(), slope = steepest(rule);
  const double slack = rule.slack_at(tips.front());
  double longest = std::min(level_length(tips), kLongestLeg * diameter);
  for (; longest > kShortestLeg * diameter; longest /= 2) {
    const std::vector<Vec3> leg = beginning(tips, longest);
    const double length = level_length(leg);
    // An even number of legs comes back to the start; equal ones use the whole slope allowed.
    const int legs = 2 * static_cast<int>(std::ceil(depth_mm / (2 * length * slope)));
    auto way = zigzag_over(leg, legs, depth_mm / (legs * length));
    if (rule.clears(way, slack)) return way;
  }
  return std::nullopt;
}

std::optional<std::vector<Vec3>> helix_to(const ApproachRule& rule, const std::vector<Vec3>& tips,
                                          double depth_mm) {
  if (tips.size() < 2) return std::nullopt;
  const Vec3 left = normalized(Vec3{tips[0].y - tips[1].y, tips[1].x - tips[0].x, 0});
  if (left == Vec3{}) return std::nullopt;
  const double slack = rule.slack_at(tips.front()),
               chord_angle = 2 * std::numbers::pi / kHelixChords;
  for (double share = kHelixShare; share >= kSmallestHelixShare; share /= 2)
    for (const double side : {1.0, -1.0}) {
      const double radius = share * rule.request.cutter.radius_mm();
      const double chord = 2 * radius * std::sin(chord_angle / 2);
      const int chords = static_cast<int>(std::ceil(depth_mm / (chord * steepest(rule))));
      auto way = helix(tips.front() + left * (side * radius), tips.front(), depth_mm,
                       side * chord_angle * chords, chords);
      if (rule.clears(way, slack)) return way;
    }
  return std::nullopt;
}

}  // namespace limitgauge::engine::strategy
