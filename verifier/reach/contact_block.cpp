#include "verifier/reach/contact_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/geometry/box_tree.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Searches for points of S that a proof may take before it is given up, and such points that a
/// piece is held against.
constexpr int kMostSearches = 80;
constexpr std::size_t kMostKnown = 24;
/// Share of its depth by which the deepest point may be missed: any deep point serves.
constexpr double kBlockShare = 0.01;
/// Places that one search for such a point may look at: along a wall that a cutter glides along, or
/// a face that lies against its bottom, nothing tells one place from the next. What was found until
/// then is a point nearer than the limit as well; nothing found means nothing proven.
constexpr int kMostPlaces = 4096;

/// Widest piece of a circle that a hull of its tangents stands for.
constexpr double kWidestHull_rad = 0.8;

Vec3 lowest_corner(const Bezier& cell, const Vec3& gradient) {
  Vec3 out = cell.control(0);
  for (const int k : {3, 12, 15})
    if (dot(gradient, cell.control(k) - out) < 0) out = cell.control(k);
  return out;
}

/// The search for a point of S at which a convex function is low: any below the start, or one
/// nearly as low as the lowest.
template <class Function>
struct LowSearch {
  const Function& function;
  double start_mm, least_mm;
  bool any = false;
  std::optional<Vec3> found = {};
  int looks = 0;

  double enough() const {
    if (looks > kMostPlaces || (any && found)) return -std::numeric_limits<double>::infinity();
    return least_mm - kBlockShare * (start_mm - least_mm);
  }
  void see(const Vec3& p, double value_mm) {
    if (value_mm < least_mm) least_mm = value_mm, found = p;
  }
  void descend(const Bezier& cell) {
    ++looks;
    const Vec3 centre = middle(cell);
    const BodyDistance d = function(centre);
    see(centre, d.value);
    if (least_by_plane(d, centre, cell) >= enough()) return;
    // What lies on an edge of S is lowest at a corner of its cells, however small they are.
    const Vec3 corner = lowest_corner(cell, d.gradient);
    see(corner, function(corner).value);
    if (least_by_plane(d, centre, cell) >= enough() ||
        control_radius(cell, centre) < kSmallestCell_mm)
      return;
    // Along an upright wall a cutter is equally near all the way up: only across it is anything
    // narrowed.
    const Change change = change_of(cell, d.gradient);
    if (change.most() < kDistanceRounding_mm) return;
    for (const Bezier& half : change.u >= change.v ? split_u(cell) : split_v(cell)) descend(half);
  }
};

/// Such a point, where the function is no less than the distance to a part with its tip at `tip`.
template <class Function>
std::optional<Vec3> low_point(const SurfaceCells& cells, const StandingPart& part, const Vec3& tip,
                              const Function& function, double start_mm, double& least_mm,
                              bool any) {
  LowSearch<Function> search{function, start_mm, least_mm, any};
  model::nearest_first(
      cells.nodes(), [&](const model::BoxNode& node) { return part_bound_mm(part, tip, node.box); },
      [&](double bound) { return bound >= search.enough(); },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
          search.descend(cells.cells()[i].shape);
      });
  least_mm = search.least_mm;
  return search.found;
}

/// Narrows [low, high] to where `value` is greatest, if it rises to there and falls behind it.
template <class Value>
void close_in(double low, double high, double finest, const Value& value) {
  constexpr int kSteps = 48;
  for (int k = 0; k < kSteps && high - low > finest; ++k) {
    const double third = (high - low) / 3;
    if (value(low + third) < value(high - third))
      low += third;
    else
      high -= third;
  }
}

}  // namespace

/// A point of S nearer than the limit to the cutter at `tip`: any, or nearly the deepest.
std::optional<ContactBlock::Obstacle> ContactBlock::obstacle_at(const Vec3& tip, double limit_mm,
                                                                bool any) const {
  std::optional<Obstacle> out;
  double least = limit_mm;
  for (std::size_t k = 0; k < parts_.size() && !(any && out); ++k) {
    const auto distance = [&](const Vec3& p) { return part_plane(parts_[k], tip, p); };
    if (const auto p = low_point(cells_, parts_[k], tip, distance, limit_mm, least, any))
      out = Obstacle{*p, k};
  }
  return out;
}

/// A point of S nearer than the limit to the cutter at every position of the piece.
std::optional<ContactBlock::Obstacle> ContactBlock::obstacle_of(const ContactRegion& g) const {
  const double limit = limit_mm_ - g.stray_mm;
  const Vec3 tip = middle_tip(g);
  const PlanPiece plan(g);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    double least = limit;
    const auto distance = [&](const Vec3& p) { return greatest_distance(parts_[k], g, plan, p); };
    if (const auto p = low_point(cells_, parts_[k], tip, distance, limit, least, true))
      return Obstacle{*p, k};
  }
  return std::nullopt;
}

/// Whether one of the obstacles bars all of a piece, the last first.
bool ContactBlock::any_holds(const ContactRegion& g, std::span<const Obstacle> obstacles) const {
  const PlanPiece plan(g);
  return std::any_of(obstacles.rbegin(), obstacles.rend(), [&](const Obstacle& o) {
    return greatest_distance(parts_[o.part], g, plan, o.point).value < limit_mm_ - g.stray_mm;
  });
}

/// The radius in plan up to which a point of S bars every tip at that height.
double ContactBlock::barred_radius_mm(const Obstacle& o, double tip_z_mm, double limit_mm) const {
  const StandingPart& part = parts_[o.part];
  const auto bars = [&](double rho) {
    const Vec3 tip{o.point.x - rho, o.point.y, tip_z_mm};
    return part_plane(part, tip, o.point).value < limit_mm;
  };
  double low = 0, high = part.profile.largest_radius_mm() + std::abs(limit_mm);
  if (!bars(low)) return 0;
  if (bars(high)) return high;
  while (high - low > kBarred_mm) {
    const double middle = (low + high) / 2;
    (bars(middle) ? low : high) = middle;
  }
  return low;
}

/// Whether the obstacles together bar all of a piece of level positions: its hull, less one disc
/// after the other.
bool ContactBlock::all_hold(const ContactRegion& g, std::span<const Obstacle> obstacles) const {
  const double z = g.cores[0].z;
  if (g.z0 != g.z1) return false;
  for (const Vec3& core : g.cores)
    if (std::abs(core.z - z) > kDistanceRounding_mm) return false;
  // A nanometre for tips that are not quite level.
  const double limit = limit_mm_ - g.stray_mm - kDistanceRounding_mm;
  PlanHull hull = hull_of(g);
  std::vector<PlanDisc> discs;
  for (const Obstacle& o : obstacles)
    if (const double radius = barred_radius_mm(o, z - g.z0, limit); radius > 0)
      discs.push_back({o.point.x, o.point.y, radius});
  return covered(std::move(hull), discs);
}

/// What is known of S by the proofs of the pieces before.
struct ContactBlock::Search {
  ContactMemory known;
  int searches = 0;
  bool inside = false;  ///< whether free places are looked for inside the outer arc, too
  double smallest_mm = 0;

  void learn(const Obstacle& o) {
    if (known.size() == kMostKnown) known.erase(known.begin());
    known.push_back(o);
  }
};

/// Learns what bars the middle of a piece, and the middle from each of the cores; false where
/// nothing does.
bool ContactBlock::learn_corners(const ContactRegion& g, Search& search) const {
  const double limit = limit_mm_ - g.stray_mm;
  ContactRegion from = g;
  const auto learn = [&] {
    const auto met = obstacle_at(middle_tip(from), limit, false);
    if (met) search.learn(*met);
    return met.has_value();
  };
  if (!learn()) return false;
  if (distance(g.cores[0], g.cores[3]) <= kSmallestCell_mm) return true;
  for (const Vec3& core : g.cores) {
    from.cores.fill(core);
    if (!learn()) return false;
  }
  return true;
}

/// Whether a single position, for all of the hull of the cores, is barred by one obstacle or by
/// those met at its corners together; learns them.
bool ContactBlock::is_spot_barred(const ContactRegion& spot, Search& search) const {
  const auto met = obstacle_at(middle_tip(spot), limit_mm_ - spot.stray_mm, false);
  if (!met) return false;
  search.learn(*met);
  if (any_holds(spot, std::span(&*met, 1))) return true;
  if (const auto all = obstacle_of(spot)) {
    search.learn(*all);
    return true;
  }
  return learn_corners(spot, search) && all_hold(spot, search.known);
}

/// Looks for a position of the region that is not barred for all of the hull of the cores: ever
/// again what is least barred by the obstacles known so far, until they bar all that is tried.
std::optional<ContactRegion> ContactBlock::free_spot(const ContactRegion& g, Search& search) const {
  constexpr int kTried = 20;
  for (int k = 0; k < kTried; ++k) {
    const ContactRegion spot = least_barred(g, search);
    const bool is_known = any_holds(spot, search.known) || all_hold(spot, search.known);
    if (!is_known && !is_spot_barred(spot, search)) return spot;
    if (is_known) break;
  }
  return std::nullopt;
}

/// Distance from the nearest of the known obstacles to the cutter in the middle of a piece.
double ContactBlock::barred_mm(const ContactRegion& spot, const Search& search) const {
  const Vec3 tip = middle_tip(spot);
  double out = std::numeric_limits<double>::max();
  for (const Obstacle& o : search.known)
    out = std::min(out, part_plane(parts_[o.part], tip, o.point).value);
  return out;
}

/// Of positions all over the region, or on its outer arc, that which the known obstacles bar least.
/// Between two walls there may be one such place only, which is closed in on along the arc, and one
/// such height only between a floor and a ceiling.
ContactRegion ContactBlock::least_barred(const ContactRegion& g, const Search& search) const {
  constexpr int kRound = 24, kRings = 2, kLevels = 8;
  ContactRegion best = g;
  double most = -std::numeric_limits<double>::infinity();
  const auto value = [&](double r, double angle, double z) {
    ContactRegion spot = g;
    spot.r0 = spot.r1 = r, spot.angle0 = spot.angle1 = angle, spot.z0 = spot.z1 = z;
    const double here = barred_mm(spot, search);
    if (here > most) most = here, best = spot;
    return here;
  };
  const double step = (g.angle1 - g.angle0) / kRound;
  const int rings = search.inside && g.r0 < g.r1 ? kRings : 0;
  for (const double z : {g.z0, g.z1}) {
    for (int ring = 0; ring <= rings; ++ring)
      for (int k = 0; k <= kRound; ++k)
        value(g.r1 + (rings ? (g.r0 - g.r1) * ring / rings : 0), g.angle0 + step * k, z);
    if (g.z0 == g.z1) break;
  }
  if (g.z0 < g.z1) {
    const double rise = (g.z1 - g.z0) / kLevels;
    const ContactRegion over = best;
    const auto at_height = [&](double z) { return value(over.r1, over.angle0, z); };
    for (int k = 1; k < kLevels; ++k) at_height(g.z0 + rise * k);
    const double z = best.z0;
    close_in(std::max(g.z0, z - rise), std::min(g.z1, z + rise), kSmallestCell_mm, at_height);
  }
  const ContactRegion from = best;
  close_in(std::max(g.angle0, from.angle0 - step), std::min(g.angle1, from.angle0 + step),
           kSmallestCell_mm / from.r1,  // without an arc there is nothing to close in on
           [&](double angle) { return value(from.r1, angle, from.z0); });
  return best;
}

std::optional<Vec3> ContactBlock::free_tip(const ContactRegion& region) const {
  Search search;
  search.inside = true;
  const auto spot = free_spot(region, search);
  return spot ? std::optional(middle_tip(*spot)) : std::nullopt;
}

bool ContactBlock::blocks(const ContactRegion& g, Search& search) const {
  if (any_holds(g, search.known)) return true;
  if (g.angle1 - g.angle0 <= kWidestHull_rad && all_hold(g, search.known)) return true;
  const double by_angle = g.r1 * (g.angle1 - g.angle0), by_r = g.r1 - g.r0, by_z = g.z1 - g.z0;
  // Of a piece smaller than the hull of the cores it is the hull that is too large.
  if (std::max({by_angle, by_r, by_z}) < search.smallest_mm) return false;
  constexpr double kWidest_rad = 1.6;  // no one point serves for more of a circle
  if (g.r1 <= 0 || g.angle1 - g.angle0 <= kWidest_rad) {
    if (++search.searches > kMostSearches) return false;
    if (const auto met = obstacle_of(g)) {
      search.learn(*met);
      return true;
    }
    if (!learn_corners(g, search)) return false;
    if (g.angle1 - g.angle0 <= kWidestHull_rad && all_hold(g, search.known)) return true;
  }
  ContactRegion low = g, high = g;
  if (by_angle >= by_r && by_angle >= by_z)
    low.angle1 = high.angle0 = (g.angle0 + g.angle1) / 2;
  else if (by_r >= by_z)
    low.r1 = high.r0 = (g.r0 + g.r1) / 2;
  else
    low.z1 = high.z0 = (g.z0 + g.z1) / 2;
  return blocks(high, search) && blocks(low, search);
}

bool ContactBlock::blocks(const ContactRegion& region, ContactMemory* memory) const {
  Search search;
  if (memory) search.known = *memory;
  for (const Vec3& corner : region.cores)
    search.smallest_mm = std::max(search.smallest_mm, distance(corner, region.cores[0]) / 2);
  const bool proven = !free_spot(region, search) && blocks(region, search);
  if (memory) *memory = std::move(search.known);
  return proven;
}

}  // namespace limitgauge::verifier
