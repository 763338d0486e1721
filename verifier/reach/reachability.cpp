#include "verifier/reach/reachability.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/box_tree.h"
#include "verifier/cutter/swept_body.h"
#include "verifier/reach/contact_hull.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

/// Directions tried where a level spot lets the flat of a cutter touch in any of them.
constexpr int kDirections = 16;
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

/// A piece of a plane, not one of a bent cell that is small. Cones are wider for rounding.
bool is_plane(const OffsetCell& cell) {
  constexpr double kRounding_rad = 2 * kArcCosineRounding_rad, kBend_per_mm = 1e-2;
  const double radius = control_radius(cell.shape, cell.middle);
  return cell.spread_rad <= std::min(kFlat_rad, kRounding_rad + kBend_per_mm * radius);
}

/// Angle of the normal at a cell's middle to the axis of the cutter.
double tilt_of(const OffsetCell& cell) {
  return std::acos(std::clamp(cell.normal.z, -1.0, 1.0));
}

/// How far a contact may be off the normal.
double lean_of(NormalOf of) {
  return of == NormalOf::face ? kLean_rad : kLevelSlope;
}

/// Searches one cell for a point nearer than the limit; empty where that stays undecided, as where
/// the effort is spent.
std::optional<bool> any_below(const StandingPart& part, const Bezier& cell, const Vec3& tip,
                              double limit_mm, int depth, int& effort) {
  if (--effort < 0) return std::nullopt;
  const Vec3 centre = middle(cell);
  const BodyDistance d = part.endless ? standing_distance(part.profile, tip, centre)
                                      : closed_standing_distance(part.profile, tip, centre);
  if (d.value < limit_mm) return true;
  if (least_by_plane(d, centre, cell) >= limit_mm) return false;
  if (depth > kDeepest || control_radius(cell, centre) < kSmallestCell_mm) return std::nullopt;
  std::optional<bool> result = false;
  for (const Bezier& half : halved(cell)) {
    const auto below = any_below(part, half, tip, limit_mm, depth + 1, effort);
    if (below && *below) return below;
    if (!below) result = below;
  }
  return result;
}

}  // namespace

Reachability::Reachability(const SurfaceCells& cells, const CutterProfile& profile,
                           double allowance_mm, double contact_mm)
    : cells_(&cells),
      profile_(profile),
      allowance_mm_(allowance_mm),
      contact_mm_(contact_mm),
      parts_{{profile, 0, true}} {}

Reachability::Reachability(const SurfaceCells& cells, const model::Cutter& cutter,
                           double allowance_mm, double contact_mm)
    : Reachability(cells, CutterProfile(cutter), allowance_mm, contact_mm) {
  double base = cutter.flute_length_mm;
  std::vector<model::CylinderPart> slim;
  bool is_wider = false;
  for (const auto* list : {&cutter.shank, &cutter.holder})
    for (const model::CylinderPart& part : *list) {
      const double radius = part.diameter_mm / 2;
      // What is wider than the flutes, and all above it, keeps no place from being in reach.
      is_wider = is_wider || radius > profile_.top_radius_mm();
      neck_ = neck_ || (!is_wider && radius < profile_.top_radius_mm());
      if (base == cutter.flute_length_mm)
        edge_is_free_ = radius <= profile_.top_radius_mm() + contact_mm;
      const double height = base + part.length_mm - profile_.top_mm;
      narrower_above_ =
          narrower_above_ || radius < profile_.top_radius_mm() + profile_.endless_slope() * height;
      if (!is_wider) slim.push_back(part);
      base += part.length_mm;
    }
  if (!neck_) return;
  parts_ = necked_parts(profile_, cutter.flute_length_mm, slim);
  // What goes on above the last part is as wide as it.
  parts_.back().endless = true;
}

Reachability Reachability::from(const SurfaceCells& cells, const model::Pose& to_own) const {
  Reachability out = *this;
  out.cells_ = &cells, out.to_own_ = to_own;
  return out;
}

Reachability Reachability::among_others() const {
  Reachability out = *this;
  out.among_others_ = true;
  return out;
}

Reachability::Below Reachability::comes_below(std::span<const StandingPart> parts, const Vec3& tip,
                                              double limit_mm) const {
  Below worst = Below::none;
  for (const StandingPart& part : parts) {
    const Vec3 base = tip + Vec3{0, 0, part.lift_mm};
    model::nearest_first(
        cells_->nodes(),
        [&](const model::BoxNode& node) { return part_bound_mm(part, tip, node.box); },
        [&](double bound) { return bound >= limit_mm || worst == Below::found; },
        [&](const model::BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
            int effort = kMostLooks;
            const auto below = any_below(part, cells_->cells()[k].shape, base, limit_mm, 0, effort);
            if (!below) worst = Below::undecided;
            if (below && *below) {
              worst = Below::found;
              return;
            }
          }
        });
    if (worst == Below::found) break;
  }
  return worst;
}

Vec3 Reachability::core_touching(const Vec3& p, const Vec3& n) const {
  return p + n * (profile_.rounding_mm + allowance_mm_) - Vec3{0, 0, profile_.core_mm};
}

std::optional<Vec3> Reachability::contact_tip(const Vec3& p, const Vec3& n, NormalOf of) const {
  const double lean = lean_of(of);
  if (n.z < slope_sine(profile_) - lean) return std::nullopt;
  const double level = std::hypot(n.x, n.y), over = over_bottom(profile_, n);
  if (profile_.is_pointed() && over < -lean) return p + n * allowance_mm_;
  if (profile_.is_pointed() && over <= lean) return std::nullopt;
  if (level <= lean && profile_.flat_mm > 0) return std::nullopt;
  const double scale = level > 0 ? profile_.flat_mm / level : 0;
  return core_touching(p, n) + Vec3{n.x * scale, n.y * scale, 0};
}

std::optional<Vec3> Reachability::touching_tip(const Vec3& p, const Vec3& n, NormalOf of) const {
  const double limit = allowance_mm_ - contact_mm_, lean = lean_of(of);
  if (n.z >= slope_sine(profile_) - lean) {
    const auto tip = contact_tip(p, n, of);
    const std::vector<Vec3> choices = tip ? std::vector{*tip} : contact_choices(p, n);
    for (const Vec3& choice : choices)
      if (comes_below(parts_, choice, limit) == Below::none) return choice;
  }
  if (neck_)
    for (const Vec3& choice : necked_choices(p, n, lean))
      if (comes_below(parts_, choice, limit) == Below::none) return choice;
  // Where one line of positions may be free, or one alone, as in a slot as wide as the cutter.
  const bool level_flat = std::hypot(n.x, n.y) <= lean && profile_.flat_mm > 0;
  if (profile_.is_pointed() || profile_.undercuts() || !level_flat) return std::nullopt;
  Bezier place;
  for (int k = 0; k < 16; ++k) place.set(k, p);
  const ContactBlock block(*cells_, parts_, limit);
  for (const ContactRegion& region : contact_regions(offset_cell(place, n, 0), lean))
    if (const auto tip = block.free_tip(region))
      if (comes_below(parts_, *tip, limit) == Below::none) return tip;
  return std::nullopt;
}

std::optional<Vec3> Reachability::tip_over_all(const Bezier& level) const {
  const model::Interval heights = control_range(level, 0, {0, 0, 1});
  const double apart = heights.high - heights.low;
  if (apart > contact_mm_ / 4 || profile_.is_pointed() || profile_.undercuts()) return std::nullopt;
  const Vec3 centre = middle(level);
  const double out = profile_.flat_mm - control_radius(level, centre) - kDistanceRounding_mm;
  if (out <= 0) return std::nullopt;
  // What stands on the higher points stands above this by no more than `apart`.
  ContactRegion over;
  over.r1 = out, over.angle0 = -pi, over.angle1 = pi;
  over.cores.fill({centre.x, centre.y, heights.low + allowance_mm_});
  const double limit = allowance_mm_ - contact_mm_ + apart;
  const auto tip = ContactBlock(*cells_, parts_, limit).free_tip(over);
  return tip && comes_below(parts_, *tip, limit) == Below::none ? tip : std::nullopt;
}

/// With the wall of the flutes at several heights, or with their top.
std::vector<Vec3> Reachability::necked_choices(const Vec3& p, const Vec3& n,
                                               double lean_rad) const {
  constexpr int kHeights = 8;
  std::vector<Vec3> tips;
  if (profile_.slope != 0) return tips;
  const double level = std::hypot(n.x, n.y), radius = profile_.top_radius_mm();
  const Vec3 touched = p + n * allowance_mm_;
  if (std::abs(n.z) <= lean_rad && level > lean_rad) {
    const Vec3 axis = touched + Vec3{n.x, n.y, 0} * (radius / level);
    for (int k = 1; k <= kHeights; ++k) {
      const double up = profile_.core_mm + (profile_.top_mm - profile_.core_mm) * k / kHeights;
      tips.push_back(axis - Vec3{0, 0, up});
    }
  } else if (n.z < 0) {
    const Vec3 axis = touched - Vec3{0, 0, profile_.top_mm};
    if (level > lean_rad) return {axis + Vec3{n.x, n.y, 0} * (radius / level)};
    for (int k = -1; k < kDirections; ++k) {
      const double angle = 2 * pi * k / kDirections, out = k < 0 ? 0 : radius;
      tips.push_back(axis + Vec3{out * std::cos(angle), out * std::sin(angle), 0});
    }
  }
  return tips;
}

std::vector<Vec3> Reachability::contact_choices(const Vec3& p, const Vec3& n) const {
  std::vector<Vec3> tips;
  if (profile_.is_pointed()) {
    // All along the bottom, from its tip to where the corner begins.
    const double level = std::hypot(n.x, n.y), sine = profile_.rise * n.z;
    if (level <= kLevelSlope) return {p + n * allowance_mm_};
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
  // A face that is not quite level has a contact of its own as well.
  if (const auto own = contact_tip(p, n, NormalOf::edge)) tips.push_back(*own);
  return tips;
}

/// All of the cell is less steep than the bottom rises, so the tip would touch it.
bool Reachability::surely_unreachable_by_tip(const OffsetCell& cell) const {
  const double spread = std::min(cell.spread_rad, pi);
  const double stray =
      control_radius(cell.shape, cell.middle) + std::abs(allowance_mm_) * 2 * std::sin(spread / 2);
  const Vec3 tip = cell.moved_middle(allowance_mm_);
  return comes_below(parts_, tip, allowance_mm_ - contact_mm_ - stray) == Below::found;
}

/// What leans inwards, or has a neck over a side that leans outwards, may touch with its side too.
bool Reachability::may_prove_unreachable() const {
  return !among_others_ && profile_.flat_mm >= 0 && !profile_.undercuts() &&
         !(neck_ && profile_.slope != 0);
}

bool Reachability::surely_unreachable(const OffsetCell& cell, ContactMemory* memory,
                                      NormalOf of) const {
  if (!may_prove_unreachable() || !(length(cell.normal) > 0)) return false;
  const double tilt = tilt_of(cell), spread = cell.spread_rad, lean = lean_of(of);
  // On flutes that widen, a shank that is no wider leaves their top edge free to touch what their
  // side does not: only what leans over is out of its reach. One that is wider would cut it first.
  const bool by_edge = narrower_above_ && edge_is_free_;
  const double steepest = by_edge ? pi / 2 : pi / 2 - std::asin(slope_sine(profile_));
  if (!neck_ && tilt - spread > steepest + lean) return true;
  if (narrower_above_ && !neck_) return false;
  if (profile_.is_pointed()) {
    const double bottom = std::atan(profile_.rise);
    if (tilt + spread < bottom - lean) return surely_unreachable_by_tip(cell);
    if (tilt - spread <= bottom + lean) return false;
  }
  // On a plane the rim of what can be reached has to be closed in on; a bent cell's own bends say
  // sooner that it is too large.
  if (!neck_ && !is_plane(cell)) {
    const bool may_stand_around = profile_.flat_mm > 0 && tilt - spread <= lean;
    return (!may_stand_around && surely_unreachable_by_hull(cell, memory)) ||
           (profile_.flat_mm > 0 && surely_unreachable_round(cell, lean));
  }
  const ContactBlock block(*cells_, parts_, allowance_mm_ - contact_mm_);
  const auto regions = contact_regions(cell, lean);
  return std::all_of(regions.begin(), regions.end(),
                     [&](const ContactRegion& region) { return block.blocks(region, memory); });
}

/// Of the endless cutter, by one point of S.
bool Reachability::surely_unreachable_by_hull(const OffsetCell& cell, ContactMemory* memory) const {
  const auto hull = ContactHull::of(cell, profile_, allowance_mm_);
  if (!hull) return false;
  const double limit = allowance_mm_ - contact_mm_;
  if (memory && !memory->empty() && hull->always_below(profile_, memory->back().point, limit))
    return true;
  // What bars all of the hull bars its middle by more than the stray.
  const auto met = ContactBlock(*cells_, parts_, limit - hull->stray_mm).deepest(hull->middle);
  if (!met) return false;
  if (memory) memory->assign(1, *met);
  return hull->always_below(profile_, met->point, limit);
}

/// Of the endless cutter, from positions round the place at so small a step that one with a flat
/// smaller by it lies inside all those between.
bool Reachability::surely_unreachable_round(const OffsetCell& cell, double lean_rad) const {
  const double tilt = tilt_of(cell), spread = cell.spread_rad;
  const double reach = profile_.rounding_mm + allowance_mm_;
  const Vec3 core = core_touching(cell.middle, cell.normal);
  // Every contact position of the cell has its core this near to one of those tried below ...
  const double stray =
      control_radius(cell.shape, cell.middle) + reach * 2 * std::sin(std::min(spread, pi) / 2);
  const double limit = allowance_mm_ - contact_mm_ - stray;
  const double flat = profile_.flat_mm;
  const bool all_round = tilt <= spread + lean_rad;
  const double aside = std::atan2(cell.normal.y, cell.normal.x);
  const double half_arc =
      all_round ? pi : std::asin(std::min(1.0, std::sin(spread) / std::sin(tilt)));
  const int samples = std::max(1, static_cast<int>(std::ceil(kCircleSamples * half_arc / pi)));
  const int rings = all_round ? kRings : 1;
  const double half_step = half_arc / samples, half_ring = all_round ? flat / (2 * kRings) : 0;
  // ... and its axis this near in plan: a cutter whose flat is smaller by that much lies inside all
  // those placed around it, so what it cuts into, they do.
  StandingPart inner = parts_.front();
  inner.profile.flat_mm = flat - std::hypot(flat * half_step, half_ring);
  if (inner.profile.flat_mm < 0) return false;
  for (int r = 0; r < rings; ++r) {
    const double out = all_round ? flat - half_ring * (2 * r + 1) : flat;
    for (int k = 0; k < samples; ++k) {
      const double angle = aside - half_arc + half_step * (2 * k + 1);
      const Vec3 tip = core + Vec3{out * std::cos(angle), out * std::sin(angle), 0};
      if (comes_below(std::span(&inner, 1), tip, limit) != Below::found) return false;
    }
  }
  return true;
}

std::vector<ContactRegion> Reachability::contact_regions(const OffsetCell& cell,
                                                         double lean_rad) const {
  const double tilt = tilt_of(cell), spread = cell.spread_rad;
  const CellRectangle around = rectangle_round(cell.shape, cell.normal);
  const double turn = 2 * std::sin(std::min(spread, pi) / 2);
  const bool all_round = tilt <= spread + lean_rad || pi - tilt <= spread + lean_rad;
  const double aside = std::atan2(cell.normal.y, cell.normal.x);
  const double half_arc =
      all_round ? pi : std::asin(std::min(1.0, std::sin(spread) / std::sin(tilt)));
  const auto region = [&](const Vec3& shift, double out, bool disc, double stray) {
    ContactRegion g{around.corners,
                    disc ? 0 : out,
                    out,
                    aside - half_arc,
                    aside + half_arc,
                    0,
                    0,
                    around.thickness_mm + stray};
    for (Vec3& core : g.cores) core += shift;
    return g;
  };
  std::vector<ContactRegion> out;
  const double reach = profile_.rounding_mm + allowance_mm_;
  if (!neck_ || tilt - spread <= pi / 2 + lean_rad)
    out.push_back(region(core_touching({}, cell.normal), std::max(0.0, profile_.flat_mm),
                         tilt <= spread + lean_rad, std::abs(reach) * turn));
  if (!neck_) return out;
  const double width = profile_.top_radius_mm(), stray = std::abs(allowance_mm_) * turn;
  if (tilt + spread >= pi / 2 - lean_rad) {
    ContactRegion wall = region(cell.normal * allowance_mm_, width, false, stray);
    wall.z0 = profile_.core_mm, wall.z1 = profile_.top_mm;
    if (tilt - spread > pi / 2 + lean_rad) wall.z0 = profile_.top_mm;  // the top alone
    if (pi - tilt <= spread + lean_rad) wall.r0 = 0;                   // any of its points
    out.push_back(wall);
  }
  return out;
}

}  // namespace limitgauge::verifier
