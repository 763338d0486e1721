#include "verifier/reach/lowest_tip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "model/geometry/box_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Share of its depth by which a deepest point may be missed: any deep point serves.
constexpr double kTipShare = 0.1;
/// A plane steeper than this says less about heights than the square's nearest corner.
constexpr double kSteep = 1e-2;
constexpr int kHalvings = 8;
constexpr int kRaises = 40;

}  // namespace

/// Positions whose axis stands within `half` of (x, y) along both axes.
struct LowestTip::Square {
  double x = 0, y = 0, half = 0;
  double low = 0;              ///< proven of all free positions in it
  std::optional<Vec3> inside;  ///< a point of S that was deep in the cutter of the square around
};

/// The search for a point of S that the cutter cuts into. None found means that no point is nearer
/// than `least` was at the start, less `slack`.
struct LowestTip::Query {
  Vec3 tip;
  double least = 0, slack = 0;
  bool any = false;  ///< the first point found will do, else one nearly as deep as the deepest
  std::optional<Vec3> found = {};
  double start = least;

  double enough() const {
    return any && found ? -std::numeric_limits<double>::infinity()
                        : least - std::max(slack, kTipShare * (start - least));
  }
};

void LowestTip::descend(const Bezier& cell, Query& query) const {
  const Vec3 centre = middle(cell);
  const BodyDistance d = standing_distance(profile_, query.tip, centre);
  if (d.value < query.least) query.least = d.value, query.found = centre;
  if (least_by_plane(d, centre, cell) >= query.enough() ||
      control_radius(cell, centre) < kSmallestCell_mm)
    return;
  for (const Bezier& half : halved(cell)) descend(half, query);
}

void LowestTip::look(Query& query) const {
  model::nearest_first(
      cells_.nodes(),
      [&](const model::BoxNode& node) { return standing_bound(profile_, query.tip, node.box); },
      [&](double bound) { return bound >= query.enough(); },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
          descend(cells_.cells()[k].shape, query);
      });
}

/// Whether no point of S is nearer than the limit; surely not where some is nearer by the margin.
bool LowestTip::is_free(const Vec3& tip, double margin_mm) const {
  Query query{tip, limit_ + margin_mm, margin_mm, true};
  look(query);
  return !query.found;
}

/// Greatest height of a tip, `rho_mm` aside of s in plan, whose endless cutter is within
/// `within_mm` of s: the section's offset by that distance, whose arcs and straight lines each
/// bound the height of s over the tip from below. None where no height is.
std::optional<double> LowestTip::highest_z(const Vec3& s, double rho_mm, double within_mm) const {
  const double reach = profile_.rounding_mm + within_mm, out = rho_mm - profile_.flat_mm;
  const double slope = profile_.endless_slope(), rise = profile_.rise;
  const double lean = std::sqrt(1 + slope * slope), shallow = std::sqrt(1 + rise * rise);
  double height = out * rise - reach * shallow;  // of s over the edge of the core, by the bottom
  if (slope > 0)
    height = std::max(height, (out - reach * lean) / slope);
  else if (out > reach)
    return std::nullopt;
  // The arc round the core's edge, between the bottom's normal and the wall's.
  if (reach > 0 && out * shallow > reach * rise && out * lean <= reach)
    height = std::max(height, -std::sqrt(std::max(0.0, reach * reach - out * out)));
  // The arc round a sharp tip, before the bottom's normal.
  if (rise > 0 && within_mm > 0 && rho_mm * shallow < within_mm * rise) {
    const double tip = profile_.tip_mm() - profile_.core_mm;
    height = std::max(height, tip - std::sqrt(within_mm * within_mm - rho_mm * rho_mm));
  }
  return s.z - height - profile_.core_mm;
}

/// The tip moved down by `by_mm` and up again as far as S pushes it, and up to twice the margin
/// further; none if that ends undecided.
std::optional<Vec3> LowestTip::lowered(Vec3 tip, double by_mm, double margin_mm) const {
  tip.z -= by_mm;
  for (int n = 0; n < kRaises; ++n) {
    Query query{tip, limit_ + margin_mm, margin_mm};
    look(query);
    if (!query.found) return tip;
    const Vec3& q = *query.found;
    const double rho = std::hypot(q.x - tip.x, q.y - tip.y);
    const auto z = highest_z(q, rho, limit_ + 2 * margin_mm);
    if (!z) return std::nullopt;
    tip.z = std::max(*z, tip.z) + kDistanceRounding_mm;
  }
  return std::nullopt;
}

Vec3 LowestTip::improved(const Vec3& tip, const Vec3& s, double settle_mm) const {
  constexpr int kFlatDirections = 8;
  constexpr double kTurn = 2.399963229728653;  // the golden angle: never the same directions twice
  const double margin = std::max(settle_mm / 8, 2 * kSmallestCell_mm);
  Vec3 best = tip;
  double value = distance(best, s);
  const auto lower = [&](double by) {
    const auto down = lowered(best, by, margin);
    if (down && distance(*down, s) < value) best = *down, value = distance(best, s);
  };
  const auto tried = [&](double x, double y) {
    const auto z = highest_z(s, std::hypot(x - s.x, y - s.y), value - settle_mm / 2);
    const Vec3 there{x, y, z.value_or(0)};
    if (!z || !(distance(there, s) < value) || !is_free(there, margin)) return false;
    best = there, value = distance(best, s);
    return true;
  };
  double step = std::max(value - limit_, 8 * settle_mm), turn = 0;
  lower(step);
  while (step > settle_mm) {
    bool moved = false;
    for (int k = 0; k < kFlatDirections && !moved; ++k) {
      const double angle = turn + 2 * std::numbers::pi * k / kFlatDirections;
      moved = tried(best.x + step * std::cos(angle), best.y + step * std::sin(angle));
    }
    turn += kTurn;
    if (moved)
      lower(step);
    else
      step /= 2;
  }
  return best;
}

/// Whether no free position of the square is within `within_mm` of s, by the point q of S: d(s − T)
/// lies above its supporting plane, so heights of such T lie below a plane over the square, and
/// d(q − T), convex in T and rising with its height, is largest at a corner of it.
bool LowestTip::excludes(const Square& square, const Vec3& s, double within_mm,
                         const Vec3& q) const {
  const double beside_x = std::max(0.0, std::abs(square.x - s.x) - square.half),
               beside_y = std::max(0.0, std::abs(square.y - s.y) - square.half);
  const double nearest = std::max(0.0, std::hypot(beside_x, beside_y) - kDistanceRounding_mm);
  if (nearest > profile_.largest_radius_mm() + within_mm + kDistanceRounding_mm) return true;
  const auto top = highest_z(s, nearest, within_mm);
  if (!top) return true;
  const auto deep = [&](double by_x, double by_y, double z) {
    const Vec3 tip{square.x + by_x * square.half, square.y + by_y * square.half,
                   z + kDistanceRounding_mm};
    return standing_distance(profile_, tip, q).value < limit_ - kDistanceRounding_mm;
  };
  const auto all_deep = [&](const auto& height) {
    return deep(-1, -1, height(-1, -1)) && deep(1, -1, height(1, -1)) &&
           deep(-1, 1, height(-1, 1)) && deep(1, 1, height(1, 1));
  };
  if (all_deep([&](double, double) { return *top; })) return true;
  const auto z = highest_z(s, std::hypot(square.x - s.x, square.y - s.y), within_mm);
  if (!z) return false;
  const BodyDistance d = standing_distance(profile_, {square.x, square.y, *z}, s);
  if (d.gradient.z > -kSteep) return false;
  return all_deep([&](double by_x, double by_y) {
    const double aside = (by_x * d.gradient.x + by_y * d.gradient.y) * square.half;
    return *z + (within_mm - d.value + aside) / -d.gradient.z;
  });
}

/// The largest value up to the goal, nearly, that q proves for the square.
double LowestTip::raise_low(const Square& square, const Vec3& s, double goal_mm,
                            const Vec3& q) const {
  if (excludes(square, s, goal_mm, q)) return goal_mm;
  double low = square.low, high = goal_mm;
  for (int n = 0; n < kHalvings; ++n) {
    const double at = (low + high) / 2;
    (excludes(square, s, at, q) ? low : high) = at;
  }
  return low;
}

LowestTip::Proof LowestTip::prove(const Vec3& s, double goal_mm,
                                  std::size_t largest_square_count) const {
  // A free position stays the limit away from every point of S, and s is one.
  Proof proof{std::min(limit_, goal_mm), {}, 0};
  // Under an undercutting cutter's side there are free positions that the endless cutter has not.
  if (goal_mm <= limit_ || profile_.undercuts()) return proof;
  const auto later = [](const Square& a, const Square& b) { return a.low > b.low; };
  std::priority_queue<Square, std::vector<Square>, decltype(later)> open(later);
  const double half = profile_.largest_radius_mm() + goal_mm + kDistanceRounding_mm;
  open.push({s.x, s.y, half, proof.low_mm, {}});
  while (!open.empty()) {
    Square at = open.top();
    if (++proof.squares > largest_square_count || at.half < kSmallestCell_mm) break;
    open.pop();
    if (at.inside) at.low = raise_low(at, s, goal_mm, *at.inside);
    const auto z = highest_z(s, std::hypot(at.x - s.x, at.y - s.y), goal_mm);
    if (at.low < goal_mm && z) {
      const Vec3 tip{at.x, at.y, *z};
      // A point cut into by much less than the square is wide proves nothing for its corners.
      Query query{tip, limit_, kTipShare * at.half};
      look(query);
      const auto& q = query.found;
      if (!q && distance(tip, s) <= goal_mm + kDistanceRounding_mm &&
          reachability_.surely_free(tip)) {
        proof.better = tip;
        return proof;
      }
      if (q) at.low = std::max(at.low, raise_low(at, s, goal_mm, *q)), at.inside = q;
    } else if (at.low < goal_mm && !at.inside) {
      at.low = std::max(at.low, raise_low(at, s, goal_mm, s));
    }
    if (at.low >= goal_mm) continue;
    const double h = at.half / 2;
    for (int k = 0; k < 4; ++k)
      open.push({at.x + (k & 1 ? h : -h), at.y + (k & 2 ? h : -h), h, at.low, at.inside});
  }
  proof.low_mm = open.empty() ? goal_mm : std::min(goal_mm, open.top().low);
  return proof;
}

}  // namespace limitgauge::verifier
