#include "verifier/contact_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verifier/nearest_first.h"
#include "verifier/swept_body.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Pieces of a region looked at before the proof is given up.
constexpr int kMostPieces = 60;
/// Share of its depth by which the deepest point may be missed: any deep point serves.
constexpr double kCoarse = 0.2;

Vec3 tip_at(const ContactRegion& g, double r, double angle, double z) {
  return g.core + Vec3{r * std::cos(angle), r * std::sin(angle), -z};
}

BodyDistance part_plane(const StandingPart& part, const Vec3& tip, const Vec3& p) {
  const Vec3 at = tip + Vec3{0, 0, part.lift_mm};
  return part.endless ? standing_distance(part.profile, at, p)
                      : closed_standing_distance(part.profile, at, p);
}

/// The search for a point of S deep in one part of the cutter.
struct DeepSearch {
  const StandingPart& part;
  Vec3 tip;
  double start_mm, least_mm;
  bool any = false;
  std::optional<Vec3> found = {};

  double enough() const {
    if (any && found) return -std::numeric_limits<double>::infinity();
    return least_mm - kCoarse * (start_mm - least_mm);
  }
  void descend(const Bezier& cell) {
    const Vec3 centre = middle(cell);
    const BodyDistance d = part_plane(part, tip, centre);
    if (d.value < least_mm) least_mm = d.value, found = centre;
    if (least_by_plane(d, centre, cell) >= enough() ||
        control_radius(cell, centre) < kSmallestCell_mm)
      return;
    for (const Bezier& half : halved(cell)) descend(half);
  }
};

}  // namespace

double part_distance_mm(const StandingPart& part, const Vec3& tip, const Vec3& p) {
  return part_plane(part, tip, p).value;
}

double part_bound_mm(const StandingPart& part, const Vec3& tip, const model::Box3& box) {
  const double dx = std::max({box.low.x - tip.x, 0.0, tip.x - box.high.x});
  const double dy = std::max({box.low.y - tip.y, 0.0, tip.y - box.high.y});
  const double base = tip.z + part.lift_mm;
  const double open = open_distance(part.profile, std::hypot(dx, dy), box.high.z - base).value;
  return part.endless ? open : std::max(open, box.low.z - base - part.profile.top_mm);
}

/// A point of S nearer than the limit: any, or one nearly as deep as the deepest.
std::optional<ContactBlock::Obstacle> ContactBlock::deep_obstacle(const Vec3& tip, double limit_mm,
                                                                  bool any) const {
  std::optional<Obstacle> out;
  double least = limit_mm;
  for (std::size_t k = 0; k < parts_.size() && !(any && out); ++k) {
    DeepSearch search{parts_[k], tip, limit_mm, least, any};
    nearest_first(
        cells_.nodes(),
        [&](const BoxNode& node) { return part_bound_mm(parts_[k], tip, node.box); },
        [&](double bound) { return bound >= search.enough(); },
        [&](const BoxNode& leaf) {
          for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
            search.descend(cells_.cells()[i].shape);
        });
    if (search.found) out = Obstacle{*search.found, k}, least = search.least_mm;
  }
  return out;
}

bool ContactBlock::holds(const ContactRegion& g, const Obstacle& obstacle) const {
  const double bulge = g.r1 * (1 - std::cos(std::min(g.angle1 - g.angle0, 3.14) / 2));
  const double limit = limit_mm_ - g.stray_mm - bulge;
  for (int k = 0; k < 8; ++k) {
    const Vec3 tip =
        tip_at(g, k & 1 ? g.r0 : g.r1, k & 2 ? g.angle0 : g.angle1, k & 4 ? g.z0 : g.z1);
    if (part_distance_mm(parts_[obstacle.part], tip, obstacle.point) >= limit) return false;
  }
  return true;
}

bool ContactBlock::blocks(const ContactRegion& g, std::optional<Obstacle> known,
                          int& effort) const {
  constexpr double kWidest_rad = 1.6;  // corners say nothing of an arc that is wider
  if (--effort < 0) return false;
  const double turn = g.angle1 - g.angle0;
  const bool narrow = turn <= kWidest_rad;
  if (known && narrow && holds(g, *known)) return true;
  const Vec3 middle_tip =
      tip_at(g, (g.r0 + g.r1) / 2, (g.angle0 + g.angle1) / 2, (g.z0 + g.z1) / 2);
  known = deep_obstacle(middle_tip, limit_mm_ - g.stray_mm);
  if (!known) return false;
  if (narrow && holds(g, *known)) return true;
  ContactRegion low = g, high = g;
  const double by_r = g.r1 - g.r0, by_z = g.z1 - g.z0;
  if (g.r1 * turn >= by_r && g.r1 * turn >= by_z)
    low.angle1 = high.angle0 = (g.angle0 + g.angle1) / 2;
  else if (by_r >= by_z)
    low.r1 = high.r0 = (g.r0 + g.r1) / 2;
  else
    low.z1 = high.z0 = (g.z0 + g.z1) / 2;
  return blocks(low, known, effort) && blocks(high, known, effort);
}

bool ContactBlock::blocks(const ContactRegion& region) const {
  // Where one position is free, or nearly, there is nothing to prove: the ends and the middle
  // first.
  constexpr int kTried = 8;
  for (int k = 0; k <= kTried; ++k) {
    const double angle = region.angle0 + (region.angle1 - region.angle0) * k / kTried;
    for (const double z : {region.z0, region.z1})
      if (!deep_obstacle(tip_at(region, region.r1, angle, z), limit_mm_ - region.stray_mm, true))
        return false;
  }
  int effort = kMostPieces;
  return blocks(region, std::nullopt, effort);
}

}  // namespace limitgauge::verifier
