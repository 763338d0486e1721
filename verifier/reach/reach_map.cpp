#include "verifier/reach/reach_map.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "model/base/chunks.h"
#include "model/geometry/box_tree.h"
#include "verifier/cutter/swept_body.h"
#include "verifier/reach/cell_contact.h"
#include "verifier/reach/contact_hull.h"
#include "verifier/reach/local_contact.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

/// Cells of S a cell may still have to be held against, before it is halved without remembering.
constexpr std::size_t kMostPending = 64;
constexpr int kLevelDirections = 16;
/// On the floor of a slot as wide as the cutter one line of positions is free, which no small cell
/// is proven by either.
constexpr double kCoarserOnLevel = 2;

/// A cell that is not proven yet, and what is known of it from the cell it is half of.
struct Open {
  CellPart cell;
  std::optional<Vec3> witness;         ///< a point of S that the cutter cuts into nearby
  std::optional<ClearedRect> cleared;  ///< proven not to be cut into
  std::vector<std::uint32_t> pending;  ///< with `cleared`: all other cells not proven so
  bool level = false;                  ///< a flat may touch with any of its points
  bool recorded = false;               ///< decided elsewhere: nothing of the above is known
};

/// Holds the control points of a cell.
struct Ball {
  Vec3 centre;
  double radius = 0;
};

class Classifier {
 public:
  Classifier(const SurfaceCells& cells, const Reachability& reachability)
      : cells_(cells),
        reachability_(reachability),
        limit_(reachability.allowance_mm() - reachability.contact_mm()),
        local_(cells.cells(), reachability.allowance_mm(), reachability.contact_mm()) {
    balls_.reserve(cells.cells().size());
    for (const SurfaceCell& cell : cells.cells()) {
      const Vec3 centre = middle(cell.shape);
      balls_.push_back({centre, control_radius(cell.shape, centre)});
    }
  }

  /// Proves the cell to be one or the other, or adds to what is known of it.
  Reach decide(Open& open, const SurfaceCell& cell) const {
    const auto contact = CellContact::of(offset_cell(cell.shape, {}), reachability_.profile(),
                                         reachability_.allowance_mm());
    if (!contact) return Reach::undecided;
    const bool endless = reachability_.is_endless();
    if (endless && contact->too_steep()) return Reach::unreachable;
    if (endless && open.witness && bars_all(*open.witness, *contact)) return Reach::unreachable;
    open.level = contact->level() && reachability_.profile().flat_mm > 0;
    if (open.level) return decide_level(cell, *contact);
    if (contact->touchable() && prove(open, cell, *contact)) return Reach::reachable;
    // Where all else of S is cleared, only what is left of it can be cut into: its middles have
    // been looked at.
    if (open.cleared && !contact->turning() && !open.witness) return Reach::undecided;
    return refute(open, cell, *contact) ? Reach::unreachable : Reach::undecided;
  }

 private:
  /// On a level spot the flat may stand anywhere over the point: one place suffices.
  Reach decide_level(const SurfaceCell& cell, const CellContact& contact) const {
    // What is cleared about a level spot does not depend on where the flat stands over it.
    const auto cleared = local_.clear(cell, contact.displaced({}));
    for (int k = -1; k < kLevelDirections; ++k) {
      const double angle = 2 * pi * k / kLevelDirections;
      const double out = k < 0 ? 0 : reachability_.profile().flat_mm;
      Open alone;
      const Vec3 aside{out * std::cos(angle), out * std::sin(angle), 0};
      if (prove_beyond(alone, cleared, contact.displaced(aside))) return Reach::reachable;
    }
    return reachability_.surely_unreachable(contact.offset()) ? Reach::unreachable
                                                              : Reach::undecided;
  }

  bool prove(Open& open, const SurfaceCell& cell, const CellContact& contact) const {
    if (!open.cleared) return prove_beyond(open, local_.clear(cell, contact), contact);
    std::erase_if(open.pending, [&](std::uint32_t k) {
      return clears(contact, open.cleared, cells_.cells()[k], open.witness);
    });
    return open.pending.empty();
  }

  /// Of all that is not cleared; what is left of it is kept.
  bool prove_beyond(Open& open, const std::optional<ClearedRect>& cleared,
                    const CellContact& contact) const {
    // A level spot may have nothing bent beside it, and then bounds on the distance do.
    if (!cleared && !contact.level()) return false;
    std::vector<std::uint32_t> pending;
    if (!search(contact, cleared, pending, open.witness)) return false;
    open.cleared = cleared, open.pending = std::move(pending);
    return open.pending.empty();
  }

  /// Gathers all cells of S that are not proven to stay clear; false when there are too many.
  bool search(const CellContact& c, const std::optional<ClearedRect>& cleared,
              std::vector<std::uint32_t>& pending, std::optional<Vec3>& witness) const {
    bool cut = false;
    model::nearest_first(
        cells_.nodes(),
        [&](const model::BoxNode& node) {
          return standing_bound(c.profile(), c.tip(), node.box) - c.stray();
        },
        [&](double bound) { return cut || bound >= limit_; },
        [&](const model::BoxNode& leaf) {
          if (below_contact_plane(c, leaf.box)) return;
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
            const SurfaceCell& other = cells_.cells()[k];
            if (cleared && local_.holds(*cleared, other)) continue;
            if (clears(c, cleared, other, balls_[k], witness)) continue;
            pending.push_back(k);
            cut = witness.has_value() || pending.size() > kMostPending;
            if (cut) return;
          }
        });
    return !cut;
  }

  bool below_contact_plane(const CellContact& c, const model::Box3& box) const {
    const Vec3 &n = c.normal(), h = box.size() * 0.5, at = box.centre();
    const double along =
        dot(n, at) + std::abs(n.x) * h.x + std::abs(n.y) * h.y + std::abs(n.z) * h.z;
    return c.over_contact_plane(along, distance(at, c.middle()) + length(h)) <=
           reachability_.contact_mm();
  }

  /// Whether the cutter stays clear of a cell of S wherever it touches the cell under test.
  bool clears(const CellContact& c, const std::optional<ClearedRect>& cleared,
              const SurfaceCell& other, std::optional<Vec3>& witness) const {
    if (cleared && local_.holds(*cleared, other)) return true;
    const Vec3 centre = middle(other.shape);
    return clears(c, cleared, other, {centre, control_radius(other.shape, centre)}, witness);
  }

  /// The same where it is not in what is cleared. What holds of a ball round it needs no look at
  /// its sixteen control points.
  bool clears(const CellContact& c, const std::optional<ClearedRect>& cleared,
              const SurfaceCell& other, const Ball& ball, std::optional<Vec3>& witness) const {
    const Vec3& centre = ball.centre;
    const BodyDistance d = standing_distance(c.profile(), c.tip(), centre);
    if (d.value < limit_ && !c.turning()) {
      witness = centre;
      return false;
    }
    const double radius = ball.radius;
    if (d.value - radius - c.stray() - kDistanceRounding_mm >= limit_) return true;
    const double apart = distance(centre, c.middle()) + radius;
    if (c.over_contact_plane(dot(c.normal(), centre) + radius + kDistanceRounding_mm, apart) <=
        reachability_.contact_mm())
      return true;
    const double base = d.value - dot(d.gradient, centre);
    double least = 1e300, along = -1e300;
    for (int k = 0; k < 16; ++k) {
      const Vec3 p = other.shape.control(k);
      least = std::min(least, dot(d.gradient, p));
      along = std::max(along, dot(c.normal(), p));
    }
    if (base + least - c.largest_shift(d.gradient) >= limit_) return true;
    if (c.over_contact_plane(along, apart) <= reachability_.contact_mm()) return true;
    if (radius < c.radius() / 2) return false;
    const auto parts = halved(other);
    return clears(c, cleared, parts[0], witness) && clears(c, cleared, parts[1], witness);
  }

  /// The middle of a cell of S that the cutter cuts into deepest: what is shallower than the
  /// middles show is too shallow to be proven for all contacts of a cell.
  std::optional<Vec3> deepest_middle(const Vec3& tip) const {
    std::optional<Vec3> found;
    const CutterProfile& profile = reachability_.profile();
    double best = limit_;
    model::nearest_first(
        cells_.nodes(),
        [&](const model::BoxNode& node) { return standing_bound(profile, tip, node.box); },
        [&](double bound) { return bound >= best; },
        [&](const model::BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
            const Vec3 p = middle(cells_.cells()[k].shape);
            const double d = standing_distance(profile, tip, p).value;
            if (d < best) best = d, found = p;
          }
        });
    return found;
  }

  /// Whether a point of S is cut into wherever the cutter touches the cell.
  bool bars_all(const Vec3& q, const CellContact& contact) const {
    if (contact.turning()) return false;
    const auto hull =
        ContactHull::of(contact.offset(), contact.profile(), reachability_.allowance_mm());
    return hull && hull->always_below(contact.profile(), q, limit_);
  }

  /// Whether some point of S is cut into wherever the cutter touches the cell.
  bool refute(Open& open, const SurfaceCell& cell, const CellContact& contact) const {
    if (!reachability_.is_endless()) return reachability_.surely_unreachable(contact.offset());
    if (contact.turning()) {
      // The middle's own contact first: a proof costs many.
      const Vec3 n = middle_normal(cell);
      return contact.alpha() < 0.3 && !reachability_.touching_tip(contact.middle(), n) &&
             reachability_.surely_unreachable(contact.offset());
    }
    open.witness = deepest_middle(contact.tip());
    return open.witness && bars_all(*open.witness, contact);
  }

  const SurfaceCells& cells_;
  const Reachability& reachability_;
  double limit_;
  LocalContact local_;
  std::vector<Ball> balls_;  ///< of the cells
};

}  // namespace

ReachMap::ReachMap(const SurfaceCells& cells, std::vector<Entry> entries)
    : entries_(std::move(entries)) {
  std::vector<IndexedCell> parts;
  parts.reserve(entries_.size());
  for (const Entry& e : entries_) {
    // A part is a point where its whole cell is one.
    IndexedCell part = indexed(cells.cells()[e.cell.whole]);
    part.rect = rect_of(e.cell);
    parts.push_back(part);
    area_[static_cast<int>(e.reach)] += e.area_mm2;
  }
  index_ = std::make_unique<const ParameterIndex>(std::span<const IndexedCell>(parts));
}

Reach ReachMap::of(const SurfaceCell& cell) const {
  const auto k = index_->find(cell.patch, cell.u_at(0.5), cell.v_at(0.5));
  if (!k || !rect_of(entries_[*k].cell).holds(rect_of(cell))) return Reach::undecided;
  return entries_[*k].reach;
}

Reach ReachMap::at(int patch, double u, double v) const {
  const Entry* entry = entry_at(patch, u, v);
  return entry ? entry->reach : Reach::undecided;
}

const ReachMap::Entry* ReachMap::entry_at(int patch, double u, double v) const {
  const auto k = index_->find(patch, u, v);
  return k ? &entries_[*k] : nullptr;
}

namespace {

/// Hundreds of thousands of them: a vector that grows would hold three times as many.
using Entries = std::deque<ReachMap::Entry>;
using OpenCells = std::deque<Open>;

/// Both, one after the other; lets go of them on the way.
std::vector<ReachMap::Entry> joined(Entries first, Entries second) {
  std::vector<ReachMap::Entry> all;
  all.reserve(first.size() + second.size());
  for (Entries* part : {&first, &second})
    for (; !part->empty(); part->pop_front()) all.push_back(part->front());
  return all;
}

using Decided = ReachDecision;

Decided decide(const Classifier& classifier, Open& open, const SurfaceCell& cell,
               const ReachOptions& options, bool last) {
  Decided decided{classifier.decide(open, cell)};
  const double smallest =
      open.level ? kCoarserOnLevel * options.smallest_radius_mm : options.smallest_radius_mm;
  decided.halve = decided.reach == Reach::undecided && !last &&
                  control_radius(cell.shape, middle(cell.shape)) > smallest;
  decided.in_u = longer_in_u(cell.shape);
  if (!decided.halve) decided.area_mm2 = area_mm2(cell.shape);
  return decided;
}

/// Puts each cell of `level` where it belongs, and lets go of it.
OpenCells sorted(OpenCells level, const std::vector<Decided>& decided, Entries& done) {
  OpenCells next;
  for (const Decided& d : decided) {
    const Open& open = level.front();
    if (!d.halve) {
      done.push_back({open.cell, d.reach, 0, d.area_mm2});
    } else {
      for (const CellPart& half : halved(open.cell, d.in_u))
        next.push_back({half, open.witness, open.cleared, open.pending, false, open.recorded});
    }
    level.pop_front();
  }
  return next;
}

/// Where a shared search stands: what its records are known by, and how many cells other parts of
/// it begin with.
struct Shared {
  const ReachSharing& with;
  std::uint32_t cutter = 0;
  std::size_t elsewhere = 0;
};

/// What was decided elsewhere; there the end of the effort may have come later.
std::optional<Decided> recorded(const Shared& shared, std::uint32_t depth, Open& open,
                                const SurfaceCells& cells, bool last) {
  const ReachDecision* found =
      shared.with.known ? shared.with.known->find(shared.cutter, depth, open.cell) : nullptr;
  if (!found && open.recorded)
    throw std::logic_error("the records of a shared search end before the search does");
  open.recorded = found != nullptr;
  if (!found) return std::nullopt;
  Decided decided = *found;
  if (decided.halve && last) {
    decided.halve = false;
    decided.area_mm2 = area_mm2(cells.cell_of(open.cell).shape);
  }
  return decided;
}

/// Halves cells until each is proven for one cutter, or the effort is spent.
Entries classify_cells(const SurfaceCells& cells, OpenCells level, const Reachability& reachability,
                       const ReachOptions& options, const Shared& shared,
                       const model::RunControl& control) {
  const Classifier classifier(cells, reachability);
  Entries done;
  std::size_t seen = shared.elsewhere;
  std::uint32_t depth = 0;
  while (!level.empty()) {
    seen += level.size();
    const bool last = seen > options.largest_cell_count;
    std::vector<Decided> decided(level.size());
    constexpr std::size_t kChunk = 64;
    model::parallel_chunks(level.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto known = recorded(shared, depth, level[i], cells, last);
        decided[i] =
            known ? *known
                  : decide(classifier, level[i], cells.cell_of(level[i].cell), options, last);
      }
    });
    if (shared.with.record)
      for (std::size_t i = 0; i < level.size(); ++i)
        shared.with.record->add(shared.cutter, depth, level[i].cell, decided[i]);
    ++depth;
    level = sorted(std::move(level), decided, done);
  }
  return done;
}

}  // namespace

ReachMap classify_reach(const SurfaceCells& cells, const Reachability& reachability,
                        const ReachOptions& options, const model::RunControl& control) {
  return classify_reach(cells, std::span(&reachability, 1), std::span(&options, 1), control);
}

ReachMap classify_reach(const SurfaceCells& cells, std::span<const Reachability> cutters,
                        std::span<const ReachOptions> options, const model::RunControl& control,
                        const ReachSharing& sharing) {
  // What is left for the next cutter, with what those before it have proven.
  Entries left, done;
  std::size_t elsewhere = 0;
  for (std::uint32_t i = 0; i < cells.cells().size(); ++i) {
    const Bezier& shape = cells.cells()[i].shape;
    if (!(control_radius(shape, shape.control(0)) > 0)) continue;
    if (i < sharing.first || i >= sharing.end)
      ++elsewhere;
    else
      left.push_back({cells.whole(i), Reach::unreachable, 0, 0});
  }
  for (std::size_t k = 0; k < cutters.size() && !left.empty(); ++k) {
    Entries next;
    for (const Reach before : {Reach::unreachable, Reach::undecided}) {
      OpenCells level;
      for (const ReachMap::Entry& e : left)
        if (e.reach == before) level.push_back({e.cell, {}, {}, {}, false, false});
      // How many are left to later cutters elsewhere is not known here: none, which is no more.
      const Shared shared{sharing, static_cast<std::uint32_t>(k),
                          k == 0 && before == Reach::unreachable ? elsewhere : 0};
      Entries found =
          classify_cells(cells, std::move(level), cutters[k], options[k], shared, control);
      for (; !found.empty(); found.pop_front()) {
        ReachMap::Entry& e = found.front();
        e.cutter = static_cast<std::uint32_t>(k);
        if (e.reach == Reach::unreachable) e.reach = before;
        (e.reach == Reach::reachable ? done : next).push_back(e);
      }
    }
    left = std::move(next);
  }
  return ReachMap(cells, joined(std::move(done), std::move(left)));
}

}  // namespace limitgauge::verifier
