#include "verifier/reachability.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/nearest_first.h"
#include "verifier/swept_body.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

/// Directions tried where a level spot lets the flat of a cutter touch in any of them.
constexpr int kDirections = 16;
constexpr double kLevel = 1e-9;  // sine of the slope below which a spot is level
constexpr int kDeepest = 60;
/// Parts of a cell looked at for one position: a contact in one point takes some dozens, one along
/// a line some thousands.
constexpr int kMostLooks = 20'000;
/// Contact positions tried around the circle of a flat cutter, and rings of them inwards.
constexpr int kCircleSamples = 24;
constexpr int kRings = 4;

double slope_sine(const CutterProfile& p) {
  return p.endless_slope() / std::sqrt(1 + p.endless_slope() * p.endless_slope());
}

/// Sine of the angle by which S with normal n is steeper than the bottom.
double over_bottom(const CutterProfile& p, const Vec3& n) {
  return (std::hypot(n.x, n.y) - n.z * p.rise) / std::sqrt(1 + p.rise * p.rise);
}

/// Searches one cell for a point nearer than the limit; empty where that stays undecided, as where
/// the effort is spent.
std::optional<bool> any_below(const CutterProfile& profile, const Bezier& cell, const Vec3& tip,
                              double limit_mm, int depth, int& effort) {
  if (--effort < 0) return std::nullopt;
  const Vec3 centre = middle(cell);
  const BodyDistance d = standing_distance(profile, tip, centre);
  if (d.value < limit_mm) return true;
  if (least_by_plane(d, centre, cell) >= limit_mm) return false;
  if (depth > kDeepest || control_radius(cell, centre) < kSmallestCell_mm) return std::nullopt;
  std::optional<bool> result = false;
  for (const Bezier& half : halved(cell)) {
    const auto part = any_below(profile, half, tip, limit_mm, depth + 1, effort);
    if (part && *part) return part;
    if (!part) result = part;
  }
  return result;
}

}  // namespace

double standing_bound(const CutterProfile& profile, const Vec3& tip, const model::Box3& box) {
  const double dx = std::max({box.low.x - tip.x, 0.0, tip.x - box.high.x});
  const double dy = std::max({box.low.y - tip.y, 0.0, tip.y - box.high.y});
  return open_distance(profile, std::sqrt(dx * dx + dy * dy), box.high.z - tip.z).value;
}

Reachability::Below Reachability::comes_below(const CutterProfile& profile, const Vec3& tip,
                                              double limit_mm) const {
  Below worst = Below::none;
  nearest_first(
      cells_.nodes(), [&](const BoxNode& node) { return standing_bound(profile, tip, node.box); },
      [&](double bound) { return bound >= limit_mm || worst == Below::found; },
      [&](const BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
          int effort = kMostLooks;
          const auto part = any_below(profile, cells_.cells()[k].shape, tip, limit_mm, 0, effort);
          if (!part) worst = Below::undecided;
          if (part && *part) {
            worst = Below::found;
            return;
          }
        }
      });
  return worst;
}

Vec3 Reachability::core_touching(const Vec3& p, const Vec3& n) const {
  return p + n * (profile_.rounding_mm + allowance_mm_) - Vec3{0, 0, profile_.core_mm};
}

std::optional<Vec3> Reachability::contact_tip(const Vec3& p, const Vec3& n) const {
  if (n.z < slope_sine(profile_) - kLevel) return std::nullopt;
  const double level = std::hypot(n.x, n.y), over = over_bottom(profile_, n);
  if (profile_.is_pointed() && over < -kLevel) return p + n * allowance_mm_;
  if (profile_.is_pointed() && over <= kLevel) return std::nullopt;
  if (level <= kLevel && profile_.flat_mm > 0) return std::nullopt;
  const double scale = level > 0 ? profile_.flat_mm / level : 0;
  return core_touching(p, n) + Vec3{n.x * scale, n.y * scale, 0};
}

std::optional<Vec3> Reachability::touching_tip(const Vec3& p, const Vec3& n) const {
  if (n.z < slope_sine(profile_) - kLevel) return std::nullopt;
  const double limit = allowance_mm_ - contact_mm_;
  if (const auto tip = contact_tip(p, n))
    return comes_below(profile_, *tip, limit) == Below::none ? tip : std::nullopt;
  for (const Vec3& tip : contact_choices(p, n))
    if (comes_below(profile_, tip, limit) == Below::none) return tip;
  return std::nullopt;
}

std::vector<Vec3> Reachability::contact_choices(const Vec3& p, const Vec3& n) const {
  std::vector<Vec3> tips;
  if (profile_.is_pointed()) {
    // All along the bottom, from its tip to where the corner begins.
    const double level = std::hypot(n.x, n.y), sine = profile_.rise * n.z;
    if (level <= kLevel) return {p + n * allowance_mm_};
    const double ends = profile_.flat_mm + profile_.rounding_mm * sine;
    for (int k = 0; k <= kDirections; ++k) {
      const double out = std::max(0.0, ends) * k / kDirections;
      const Vec3 along{out * n.x / level, out * n.y / level, -out * profile_.rise};
      tips.push_back(p + n * allowance_mm_ + along);
    }
    return tips;
  }
  for (int k = -1; k < kDirections; ++k) {
    const double angle = 2 * pi * k / kDirections, reach = k < 0 ? 0 : profile_.flat_mm;
    tips.push_back(core_touching(p, n) + Vec3{reach * std::cos(angle), reach * std::sin(angle), 0});
  }
  return tips;
}

/// All of the cell is less steep than the bottom rises, so the tip would touch it.
bool Reachability::surely_unreachable_by_tip(const Bezier& cell, const NormalCone& cone) const {
  const Vec3 centre = middle(cell);
  const double spread = std::min(cone.half_angle_rad, pi);
  const double stray =
      control_radius(cell, centre) + std::abs(allowance_mm_) * 2 * std::sin(spread / 2);
  const Vec3 tip = centre + cone.axis * allowance_mm_;
  return comes_below(profile_, tip, allowance_mm_ - contact_mm_ - stray) == Below::found;
}

bool Reachability::surely_unreachable(const Bezier& cell) const {
  if (profile_.flat_mm < 0) return false;
  const auto cone = normal_cone(cell);
  if (!cone) return false;
  const double tilt = std::acos(std::clamp(cone->axis.z, -1.0, 1.0)), spread = cone->half_angle_rad;
  if (!profile_.undercuts() && tilt - spread > pi / 2 - std::asin(slope_sine(profile_)))
    return true;
  if (profile_.is_pointed()) {
    const double bottom = std::atan(profile_.rise);
    if (tilt + spread < bottom - kLevel) return surely_unreachable_by_tip(cell, *cone);
    if (tilt - spread <= bottom + kLevel) return false;
  }
  // What leans inwards may touch with its side too.
  if (profile_.undercuts()) return false;

  const Vec3 centre = middle(cell);
  const double reach = profile_.rounding_mm + allowance_mm_;
  const Vec3 core = core_touching(centre, cone->axis);
  // Every contact position of the cell has its core this near to one of those tried below ...
  const double stray =
      control_radius(cell, centre) + reach * 2 * std::sin(std::min(spread, pi) / 2);
  const double limit = allowance_mm_ - contact_mm_ - stray;
  const double flat = profile_.flat_mm;
  if (flat <= 0) return comes_below(profile_, core, limit) == Below::found;
  const bool all_round = tilt <= spread + kLevel;
  const double aside = std::atan2(cone->axis.y, cone->axis.x);
  const double half_arc =
      all_round ? pi : std::asin(std::min(1.0, std::sin(spread) / std::sin(tilt)));
  const int samples = std::max(1, static_cast<int>(std::ceil(kCircleSamples * half_arc / pi)));
  const int rings = all_round ? kRings : 1;
  const double half_step = half_arc / samples, half_ring = all_round ? flat / (2 * kRings) : 0;
  // ... and its axis this near in plan: a cutter whose flat is smaller by that much lies inside all
  // those placed around it, so what it cuts into, they do.
  CutterProfile inner = profile_;
  inner.flat_mm = flat - std::hypot(flat * half_step, half_ring);
  if (inner.flat_mm < 0) return false;
  for (int r = 0; r < rings; ++r) {
    const double out = all_round ? flat - half_ring * (2 * r + 1) : flat;
    for (int k = 0; k < samples; ++k) {
      const double angle = aside - half_arc + half_step * (2 * k + 1);
      const Vec3 tip = core + Vec3{out * std::cos(angle), out * std::sin(angle), 0};
      if (comes_below(inner, tip, limit) != Below::found) return false;
    }
  }
  return true;
}

}  // namespace limitgauge::verifier
