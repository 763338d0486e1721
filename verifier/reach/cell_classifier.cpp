#include "verifier/reach/cell_classifier.h"

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

/// Cells of S a cell may still have to be held against, before it is halved without remembering.
constexpr std::size_t kMostPending = 64;
constexpr int kLevelDirections = 16;
/// Parts of one cell of S that are looked at for one contact: a contact of a nanometre, beside an
/// irregular vertex, would have it cut into a hundred thousand in vain. Most take some dozens.
constexpr int kMostParts = 1000;

}  // namespace

CellClassifier::CellClassifier(const SurfaceCells& cells, const Reachability& reachability)
    : cells_(cells),
      reachability_(reachability),
      limit_(reachability.allowance_mm() - reachability.contact_mm()),
      local_(cells.cells(), reachability.allowance_mm(), reachability.contact_mm()) {}

Reach CellClassifier::decide(OpenCell& open, const SurfaceCell& cell, CellHalves& parts) const {
  const auto contact = CellContact::of(offset_cell(cell.shape, {}), reachability_.profile(),
                                       reachability_.allowance_mm());
  if (!contact) return Reach::undecided;
  const bool endless = reachability_.is_endless();
  if (endless && contact->too_steep()) return Reach::unreachable;
  if (endless && open.witness && bars_all(*open.witness, *contact)) return Reach::unreachable;
  open.level = contact->level() && reachability_.profile().flat_mm > 0;
  if (open.level) return decide_level(cell, open.cell.whole, *contact, parts);
  if (contact->touchable() && prove(open, cell, *contact, parts)) return Reach::reachable;
  // Where all else of S is cleared, only what is left of it can be cut into: its middles have
  // been looked at.
  if (open.cleared && !contact->turning() && !open.witness) return Reach::undecided;
  return refute(open, cell, *contact) ? Reach::unreachable : Reach::undecided;
}

/// On a level spot the flat may stand anywhere over the point: one place suffices, which is carried
/// along with the points of the cell or, as in a slot hardly wider than the cutter, stays where it
/// is.
Reach CellClassifier::decide_level(const SurfaceCell& cell, std::uint32_t whole,
                                   const CellContact& contact, CellHalves& parts) const {
  // What is cleared about a level spot does not depend on where the flat stands over it.
  const auto cleared = local_.clear(cell, contact.displaced({}), whole);
  for (int k = -1; k < kLevelDirections; ++k) {
    const double angle = 2 * pi * k / kLevelDirections;
    const double out = k < 0 ? 0 : reachability_.profile().flat_mm;
    OpenCell alone;
    const Vec3 aside{out * std::cos(angle), out * std::sin(angle), 0};
    if (prove_beyond(alone, cleared, contact.displaced(aside), parts)) return Reach::reachable;
    if (k < 0 && reachability_.tip_over_all(cell.shape)) return Reach::reachable;
  }
  return reachability_.surely_unreachable(contact.offset()) ? Reach::unreachable : Reach::undecided;
}

bool CellClassifier::prove(OpenCell& open, const SurfaceCell& cell, const CellContact& contact,
                           CellHalves& parts) const {
  if (!open.cleared)
    return prove_beyond(open, local_.clear(cell, contact, open.cell.whole), contact, parts);
  std::erase_if(open.pending, [&](std::uint32_t k) {
    return clears_cell(contact, open.cleared, k, parts, open.witness);
  });
  return open.pending.empty();
}

/// Of all that is not cleared; what is left of it is kept.
bool CellClassifier::prove_beyond(OpenCell& open, const std::optional<Cleared>& cleared,
                                  const CellContact& contact, CellHalves& parts) const {
  // Where nothing is bent, the contact plane does: on an upright wall the cutter's straight side
  // leaves the curvature's proof no room, and facets of a mesh are bent by rounding alone.
  if (!cleared && !contact.level() && !contact.clears_itself(reachability_.contact_mm()))
    return false;
  std::vector<std::uint32_t> pending;
  if (!search(contact, cleared, pending, open.witness, parts)) return false;
  open.cleared = cleared, open.pending = std::move(pending);
  return open.pending.empty();
}

/// Gathers all cells of S that are not proven to stay clear; false when there are too many.
bool CellClassifier::search(const CellContact& c, const std::optional<Cleared>& cleared,
                            std::vector<std::uint32_t>& pending, std::optional<Vec3>& witness,
                            CellHalves& parts) const {
  bool cut = false;
  model::nearest_first(
      cells_.nodes(),
      [&](const model::BoxNode& node) {
        const double bound = standing_bound(c.profile(), c.tip(), node.box) - c.stray();
        return bound < limit_ && below_contact_plane(c, node.box) ? limit_ : bound;
      },
      [&](double bound) { return cut || bound >= limit_; },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
          if (clears_cell(c, cleared, k, parts, witness)) continue;
          pending.push_back(k);
          cut = witness.has_value() || pending.size() > kMostPending;
          if (cut) return;
        }
      });
  return !cut;
}

bool CellClassifier::below_contact_plane(const CellContact& c, const model::Box3& box) const {
  const Vec3 &n = c.normal(), h = box.size() * 0.5, at = box.centre();
  const double along = dot(n, at) + std::abs(n.x) * h.x + std::abs(n.y) * h.y + std::abs(n.z) * h.z;
  return c.over_contact_plane(along, distance(at, c.middle()) + length(h)) <=
         reachability_.contact_mm();
}

/// Whether the cutter stays clear of a cell of S wherever it touches the cell under test.
bool CellClassifier::clears_cell(const CellContact& c, const std::optional<Cleared>& cleared,
                                 std::uint32_t index, CellHalves& parts,
                                 std::optional<Vec3>& witness) const {
  Looks looks{parts, witness, index, kMostParts};
  return clears(c, cleared, parts.whole(index), looks);
}

/// The same of a part of it. What holds of a ball round it needs no look at its sixteen control
/// points.
bool CellClassifier::clears(const CellContact& c, const std::optional<Cleared>& cleared,
                            CellHalves::Part& other, Looks& looks) const {
  if (--looks.left < 0) return false;
  if (cleared && local_.holds(*cleared, looks.whole, other)) return true;
  const Vec3& centre = other.middle;
  const BodyDistance d = standing_distance(c.profile(), c.tip(), centre);
  if (d.value < limit_ && !c.turning()) {
    looks.witness = centre;
    return false;
  }
  const double radius = other.radius_mm;
  if (d.value - radius - c.stray() - kDistanceRounding_mm >= limit_) return true;
  const double apart = distance(centre, c.middle()) + radius;
  if (c.over_contact_plane(dot(c.normal(), centre) + radius + kDistanceRounding_mm, apart) <=
      reachability_.contact_mm())
    return true;
  if (clears_by_distance(c, other, d) || clears_by_plane(c, other, apart) ||
      clears_by_its_plane(c, other))
    return true;
  if (radius < c.radius() / 2) return false;
  auto& halves = looks.parts.halves_of(other);
  // What failed for a neighbour first: it is the likeliest to fail again.
  for (const bool second : {other.second_first, !other.second_first}) {
    if (clears(c, cleared, halves[second], looks)) continue;
    other.second_first = second;
    return false;
  }
  return true;
}

/// By the supporting plane of the distance `d` at the other cell's middle. The middle is in the
/// hull of the control points, whose ranges are looked at where they decide.
bool CellClassifier::clears_by_distance(const CellContact& c, const CellHalves::Part& other,
                                        const BodyDistance& d) const {
  const double turning = c.turning_shift(d.gradient);
  if (d.value - turning + kDistanceRounding_mm < limit_) return false;
  const double base = d.value - dot(d.gradient, other.middle);
  const double least = base + control_range(other.cell->shape, 0, d.gradient).low;
  if (least - turning + kDistanceRounding_mm < limit_) return false;
  if (least - turning - c.radius() - kDistanceRounding_mm >= limit_) return true;
  return least - c.largest_shift(d.gradient) >= limit_;
}

/// By the contact plane, over points no further than `apart` from the middle of the contact.
bool CellClassifier::clears_by_plane(const CellContact& c, const CellHalves::Part& other,
                                     double apart) const {
  const auto below = [&](double along) {
    return c.over_contact_plane(along, apart) <= reachability_.contact_mm();
  };
  if (!below(dot(c.normal(), other.middle) - kDistanceRounding_mm)) return false;
  return below(control_range(other.cell->shape, 0, c.normal()).high);
}

/// By the cutter's supporting plane that is parallel to the other cell: beside a wall the one at
/// its middle is turned against it, and serves for a small part of it only. d(q − T) ≥ g·(q − T) −
/// the cutter's extent along g, for any unit vector g.
bool CellClassifier::clears_by_its_plane(const CellContact& c,
                                         const CellHalves::Part& other) const {
  const CutterProfile& profile = c.profile();
  if (profile.flat_mm < 0 || profile.is_pointed() || profile.undercuts()) return false;
  const Vec3 n = middle_normal(*other.cell);
  const double level = std::hypot(n.x, n.y);
  // The side's own plane is as near as the cutter has one where a wall leans further over.
  const double up = std::min(-n.z, -level * profile.slope), length = std::hypot(level, up);
  if (!(length > 0)) return false;
  const Vec3 g{-n.x / length, -n.y / length, up / length};
  const double base = dot(g, c.tip()) + profile.extent_mm(level / length, up / length);
  const double least = control_range(other.cell->shape, 0, g).low - base - kDistanceRounding_mm;
  return least >= limit_ && least - c.largest_shift(g) >= limit_;
}

/// The middle of a cell of S that the cutter cuts into deepest: what is shallower than the
/// middles show is too shallow to be proven for all contacts of a cell.
std::optional<Vec3> CellClassifier::deepest_middle(const Vec3& tip) const {
  std::optional<Vec3> found;
  const CutterProfile& profile = reachability_.profile();
  double best = limit_;
  model::nearest_first(
      cells_.nodes(),
      [&](const model::BoxNode& node) { return standing_bound(profile, tip, node.box); },
      [&](double bound) { return bound >= best; },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
          const Vec3& p = local_.middles()[k];
          const double d = standing_distance(profile, tip, p).value;
          if (d < best) best = d, found = p;
        }
      });
  return found;
}

/// Whether a point of S is cut into wherever the cutter touches the cell.
bool CellClassifier::bars_all(const Vec3& q, const CellContact& contact) const {
  if (contact.may_stand_around()) return false;
  const auto hull =
      ContactHull::of(contact.offset(), contact.profile(), reachability_.allowance_mm());
  return hull && hull->always_below(contact.profile(), q, limit_);
}

/// Whether some point of S is cut into wherever the cutter touches the cell.
bool CellClassifier::refute(OpenCell& open, const SurfaceCell& cell,
                            const CellContact& contact) const {
  if (!reachability_.is_endless()) return reachability_.surely_unreachable(contact.offset());
  if (contact.may_stand_around()) {
    // The middle's own contact first: a proof costs many.
    const Vec3 n = middle_normal(cell);
    return contact.alpha() < 0.3 && !reachability_.touching_tip(contact.middle(), n) &&
           reachability_.surely_unreachable(contact.offset());
  }
  open.witness = deepest_middle(contact.tip());
  return open.witness && bars_all(*open.witness, contact);
}

}  // namespace limitgauge::verifier
