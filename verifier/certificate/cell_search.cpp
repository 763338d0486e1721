#include "verifier/certificate/cell_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "verifier/certificate/rim_strips.h"
#include "verifier/certificate/run_bounds.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Share of all the effort that one cell may take before it is given up, so that one bad spot
/// cannot hold up a run; and cells it may take once the verdict is settled.
constexpr double kShareOfCell = 0.003;
constexpr std::size_t kOnceSettled = 10;
/// Cells that a search for what can touch a piece of a face counts as: it takes as long as they do.
constexpr std::size_t kCellsOfReach = 8;
/// Where the normals of an edge have no cone that shrinks, halving ends.
constexpr int kDeepest = 120;
/// Part of the resolution that branch and bound may use; the rest is for rounding.
constexpr double kShare = 0.95;

/// How wide an interval may be whose low end is known so far.
double wanted_width_mm(const CertificateRequest& request, double low_mm, double limit_mm,
                       double errors_mm) {
  constexpr double kFinestShare = 0.01;
  const double asked = request.resolution_mm;
  if (low_mm > limit_mm + errors_mm) return std::max(asked, kSettledShare * low_mm);
  const double room = limit_mm - errors_mm - low_mm;
  return room > 0 && room < asked ? std::max(room, kFinestShare * asked) : asked;
}

bool is_tiny(const SurfaceCell&, const OffsetCell& o) {
  return control_radius(o.shape, o.middle) < kSmallestCell_mm;
}
bool is_tiny(const RidgeCell& cell, const OffsetCell&) {
  return cell.is_tiny();
}
/// With its middle's normal for all of it: beside an irregular vertex the normals of a nanometre
/// may still be some degrees apart.
OffsetCell as_spot(const SurfaceCell&, OffsetCell o) {
  o.remainder = 0, o.turning = {};
  return o;
}
OffsetCell as_spot(const RidgeCell&, const OffsetCell& o) {
  return o;
}

/// A millionth of the cell about its middle, with the middle's normal.
OffsetCell shrunk(OffsetCell o) {
  constexpr double kShrunk = 1e-6;
  for (int k = 0; k < 16; ++k) o.shape.set(k, o.middle + (o.shape.control(k) - o.middle) * kShrunk);
  o.remainder *= kShrunk, o.spread_rad *= kShrunk;
  return o;
}

/// Longest way of a cell, as a multiple of the shorter, beyond which only that is halved: bounds on
/// bent cells are no better for slivers, those on a plane beside a straight edge are.
constexpr double kLongest = 8, kLongestOnPlane = 64;
double longest_way(const OffsetCell& cell) {
  return cell.remainder <= kPlane_mm ? kLongestOnPlane : kLongest;
}

/// Splits where δ changes most: across the passes far more than along them.
std::array<SurfaceCell, 2> halves_of(const SurfaceCell& cell, const Vec3& gradient,
                                     const OffsetCell& offset, double) {
  const InnerChords chords = inner_chords(cell.shape);
  const double wide = length(chords.u), tall = length(chords.v), most = longest_way(offset);
  if (wide > most * tall || tall > most * wide) return wide > tall ? split_u(cell) : split_v(cell);
  const double bend_u = std::abs(dot(gradient, chords.u));
  const double bend_v = std::abs(dot(gradient, chords.v));
  return bend_u + 0.02 * wide >= bend_v + 0.02 * tall ? split_u(cell) : split_v(cell);
}
std::array<RidgeCell, 2> halves_of(const RidgeCell& cell, const Vec3&, const OffsetCell&,
                                   double t_mm) {
  return cell.halved(t_mm);
}

/// Depth-first refinement of one cell of the list, from what the batches before it have found.
class CellSearch {
 public:
  CellSearch(const CertificateTask& task, const CellOutcome& before,
             const model::RunControl& control, const std::shared_ptr<FarPasses>& far)
      : task_(task),
        control_(control),
        bounds_(task.cells, task.space, task.side, task.request.allowance_mm, task.draws, far),
        may_split_(before.cells < task.request.largest_cell_count && !is_open(before)) {
    out_.low = before.low, out_.high = before.high;
  }

  CellOutcome run(const SurfaceCell& cell) {
    whole_ = &cell;
    search(cell, 0);
    return out_;
  }
  CellOutcome run(const RidgeCell& cell) {
    search(cell, 0);
    return out_;
  }

 private:
  double goal() const { return task_.goal(out_.low); }
  /// Of a search that only decides: whether some cell is proven neither way, so that no other
  /// makes it pass.
  bool is_open(const CellOutcome& found) const {
    return task_.request.decides_only && found.high > task_.deciding_mm();
  }
  bool spent() const {
    if (!may_split_ || is_open(out_)) return true;
    if (task_.settled(out_.low)) return out_.cells > kOnceSettled;
    return static_cast<double>(out_.cells + kCellsOfReach * reach_searches_) >
           kShareOfCell * static_cast<double>(task_.request.largest_cell_count);
  }

  template <class Cell>
  void search(const Cell& cell, int depth) {
    // Where reach has no proof, a cell may take milliseconds.
    control_.check();
    if (task_.request.decides_only && task_.settled(out_.low)) return;
    ++out_.cells;
    const OffsetCell offset = offset_of(cell);
    if (bounds_.surely_within(offset, goal())) return out_.cover(goal());
    if (is_left_out(cell)) return;
    bool out_of_reach = false;
    // A run that ends before the goal would raise `low` by less than what is asked for.
    const bool tiny = depth >= kDeepest || is_tiny(cell, offset);
    if (tiny || may_stand_above(depth) || !bounds_.ends_within(offset, goal())) {
      const TracedRun run = bounds_.run(offset.middle, offset.normal, out_.low);
      if (run.length_mm > out_.low) {
        if (surely_unreachable(cell, offset)) return;
        const SurfacePlace place = place_of(cell, offset.middle);
        out_of_reach = !task_.counts(cell, place, offset.normal);
        if (!out_of_reach) {
          out_.see({place, run.length_mm, body_of(run, offset.middle), offset.normal, run.shift_x,
                    run.shift_y});
          climb(cell, run);
          if (bounds_.surely_within(offset, goal())) return out_.cover(goal());
        }
      }
      if (!out_of_reach && bounds_.surely_within_thin(offset, run, goal()))
        return out_.cover(goal());
      // The middle's run is short, another one of the cell may not be: of a cell out of reach it
      // need not be found.
      if (run.length_mm <= out_.low && surely_unreachable(cell, offset)) return;
    }
    // Of a space that sways, a middle's run by a plane is a run but for its bend.
    if (task_.draws && is_small_to_sway(offset) && surely_unreachable(cell, offset)) return;
    // A spot of a nanometre counts as its middle does: far below the contact tolerance.
    if (tiny && out_of_reach) return;
    if (tiny && bounds_.surely_within(as_spot(cell, offset), goal())) return out_.cover(goal());
    if (!tiny && !out_of_reach && ends_at_errors(cell, offset)) return;
    const auto strips = tiny ? std::nullopt : within_strips(cell, offset);
    if (strips && *strips) return out_.cover(goal());
    if (tiny || spent()) return give_up(offset);
    // Along an open end of S the rim of reach is another than the one that strips lie along.
    const bool by_reach = out_of_reach && (!strips || is_at_rim(cell));
    const auto halves = by_reach ? halves_by_reach(cell, offset) : halves_of(cell, offset);
    search(halves[0], depth + 1);
    search(halves[1], depth + 1);
  }

  bool is_small_to_sway(const OffsetCell& offset) const {
    return control_radius(offset.shape, offset.middle) < length(task_.space.sway());
  }

  /// Of moves that have errors of their own: whether those, not the cell's size, keep it from the
  /// goal. What they take from the bound at the middle they take from that of every cell about it:
  /// `high` is raised to what is proven there, and no cell need be better than that.
  template <class Cell>
  bool ends_at_errors(const Cell& cell, const OffsetCell& offset) {
    constexpr double kSmall = 4, kSmallest = 0.25;
    if (!task_.draws) return false;
    const double radius = control_radius(offset.shape, offset.middle);
    if (radius > kSmall * task_.draws->own_errors_mm()) return false;
    // Where bounds leap, as beside a wall, the middle may lie on the better side.
    const bool may_leap = radius < kSmallest * task_.request.resolution_mm && out_.high > goal();
    if (may_leap && bounds_.surely_within(offset, out_.high)) return true;
    const OffsetCell spot = shrunk(offset);
    if (bounds_.surely_within(spot, goal()) ||
        !task_.counts(cell, place_of(cell, offset.middle), offset.normal))
      return false;
    if (task_.request.decides_only) {
      out_.cover(std::numeric_limits<double>::infinity());
    } else {
      out_.cover(proven_at(spot));
    }
    return bounds_.surely_within(offset, out_.high);
  }

  /// A length within which the spot is proven to be, the least of them within a share of the
  /// resolution that is above the goal and what `high` is already.
  double proven_at(const OffsetCell& spot) {
    constexpr double kShareOfSpot = 0.25;
    const double longest = bounds_.longest_mm();
    double step = kShareOfSpot * task_.request.resolution_mm;
    double length = std::max(goal(), out_.high);
    while (length < longest && !bounds_.surely_within(spot, length)) length += step, step *= 1.25;
    return std::min(length, longest);
  }

  /// Behind a sharp edge a cell may stand at the goal with its middle only, and above it as a
  /// whole.
  bool may_stand_above(int depth) const {
    constexpr int kEvery = 4;
    return task_.side != Side::uncut && depth % kEvery == kEvery - 1;
  }

  /// A cutter beside the part touches its very rim wherever the part ends in the open, and within
  /// the contact tolerance of it: no leftover is narrower than what can be seen.
  bool is_left_out(const SurfaceCell& cell) const {
    return task_.side == Side::uncut && task_.cells.is_rim_strip(cell, kBeside_mm);
  }
  static bool is_left_out(const RidgeCell&) { return false; }
  bool is_at_rim(const SurfaceCell& cell) const {
    return task_.cells.is_rim_strip(cell, std::numeric_limits<double>::infinity());
  }
  static bool is_at_rim(const RidgeCell&) { return false; }

  template <class Cell>
  std::array<Cell, 2> halves_of(const Cell& cell, const OffsetCell& offset) {
    return verifier::halves_of(cell, bounds_.gradient_at(offset, goal()), offset,
                               task_.request.allowance_mm + goal());
  }
  /// Beside the rim of what can be reached: so that one half is out of reach, if that can be.
  std::array<SurfaceCell, 2> halves_by_reach(const SurfaceCell& cell, const OffsetCell& offset) {
    const InnerChords chords = inner_chords(cell.shape);
    const double wide = length(chords.u), tall = length(chords.v);
    const bool u_first = wide >= tall;
    for (const bool by_u : {u_first, !u_first}) {
      if (by_u ? tall > kLongestOnPlane * wide : wide > kLongestOnPlane * tall) continue;
      const auto halves = by_u ? split_u(cell) : split_v(cell);
      if (surely_unreachable(halves[0], offset_of(halves[0])) ||
          surely_unreachable(halves[1], offset_of(halves[1])))
        return halves;
    }
    return halves_of(cell, offset);
  }
  /// What the cutter touches ends at one of the normals, as at the level one of an overhang: all
  /// along the edge.
  std::array<RidgeCell, 2> halves_by_reach(const RidgeCell& cell, const OffsetCell& offset) {
    if (cell.fan_rad() > kSmallestFan_rad) {
      const auto halves = cell.halved_fan();
      if (surely_unreachable(halves[0], halves[0].offset()) ||
          surely_unreachable(halves[1], halves[1].offset()))
        return halves;
    }
    return halves_of(cell, offset);
  }
  std::optional<bool> within_strips(const SurfaceCell&, const OffsetCell& offset) {
    if (task_.side != Side::uncut) return std::nullopt;
    return RimStrips(bounds_, *task_.reach, memory_)
        .surely_within(offset, task_.request.allowance_mm, goal());
  }
  static std::optional<bool> within_strips(const RidgeCell&, const OffsetCell&) { return {}; }
  bool surely_unreachable(const SurfaceCell& cell, const OffsetCell& offset) {
    if (task_.side != Side::uncut) return false;
    if (!task_.reach->is_mapped(cell)) ++reach_searches_;
    return task_.reach->surely_unreachable(cell, offset, &memory_);
  }
  /// Normals that are so near to each other count as the middle one does.
  bool surely_unreachable(const RidgeCell& cell, const OffsetCell& offset) {
    if (task_.side != Side::uncut) return false;
    return task_.reach->ridge_surely_unreachable(offset, &memory_) ||
           (cell.fan_rad() <= kSmallestFan_rad &&
            task_.reach->ridge_surely_unreachable(cell.without_fan().offset(), &memory_));
  }

  /// A place of the whole cell, and of a space that sways the share of its shift there.
  struct Stand {
    double s = 0, t = 0, x = 0, y = 0;
  };

  /// From the middle of a part of the whole cell to where its runs are longest, by a compass
  /// search: else a run that grows over it would be followed up one width of the interval at a
  /// time. Of a space that sways the shift is searched as well.
  void climb(const SurfaceCell& from, const TracedRun& run) {
    constexpr double kFirst = 0.25, kFinest = 1e-3;
    const SurfaceCell& whole = *whole_;
    // Next to an open end of S strips are left out, and beside an irregular vertex the normals of a
    // micrometre are rounding.
    if (is_at_rim(whole) || length(whole.vertex_normal) > 0) return;
    Stand at{(from.u_at(0.5) - whole.u) / whole.size_u, (from.v_at(0.5) - whole.v) / whole.size_v,
             run.shift_x, run.shift_y};
    for (double step = kFirst; step > kFinest;)
      if (!steps_up(at, step)) step /= 2;
  }
  void climb(const RidgeCell&, const TracedRun&) {}

  /// One step to a longer run, if there is any.
  bool steps_up(Stand& at, double step) {
    // On its border a place may have further normals.
    constexpr double kInside = 1.0 / 64;
    constexpr int kU[] = {1, 0, -1, 0, 1, -1, -1, 1}, kV[] = {0, 1, 0, -1, 1, 1, -1, -1};
    const int ways = task_.draws ? 16 : 8;
    for (int k = 0; k < ways; ++k) {
      Stand next = at;
      const double by_u = kU[k % 8] * step, by_v = kV[k % 8] * step;
      if (k < 8) {
        next.s = std::clamp(at.s + by_u, kInside, 1 - kInside);
        next.t = std::clamp(at.t + by_v, kInside, 1 - kInside);
      } else {
        next.x = std::clamp(at.x + 2 * by_u, -1.0, 1.0);
        next.y = std::clamp(at.y + 2 * by_v, -1.0, 1.0);
      }
      if (!see_at(next)) continue;
      at = next;
      return true;
    }
    return false;
  }

  /// Whether a longer run than any so far counts there.
  bool see_at(const Stand& at) {
    const BezierJet jet = verifier::jet(whole_->shape, at.s, at.t);
    const Vec3 across = cross(jet.du, jet.dv);
    if (!(length(across) > 0)) return false;
    const Vec3 n = normalized(across);
    // What is longer by less than can be told closes no cell.
    const double least = out_.low + kShare * (1 - kShare) * task_.request.resolution_mm;
    const TracedRun run = task_.draws ? bounds_.run_shifted(jet.position, n, at.x, at.y, least)
                                      : bounds_.run(jet.position, n, least);
    const SurfacePlace place{whole_->patch, whole_->u_at(at.s), whole_->v_at(at.t), jet.position};
    if (run.length_mm <= least || !task_.counts(*whole_, place, n)) return false;
    out_.see({place, run.length_mm, body_of(run, jet.position), n, run.shift_x, run.shift_y});
    return true;
  }

  /// The move to name: of a gouge the one that reaches furthest, of a leftover the nearest.
  BodyRef body_of(const TracedRun& run, const Vec3& s) {
    return task_.side != Side::uncut && run.body ? *run.body : bounds_.nearest_body(s);
  }

  /// Without refinement: the first of ever longer runs that is proven.
  void give_up(const OffsetCell& offset) {
    if (task_.request.decides_only) return out_.cover(std::numeric_limits<double>::infinity());
    const double longest = bounds_.longest_mm(), first = std::max(goal(), out_.high);
    if (first >= longest) return;
    double share = 0;
    for (double length = first; length < longest; length = first * (1 + share)) {
      if (bounds_.surely_within(offset, length)) return out_.cover(length);
      share = share > 0 ? 2 * share : 0.05;
    }
    out_.cover(longest);
  }

  const CertificateTask& task_;
  const model::RunControl& control_;
  RunBounds bounds_;
  ReachMemory memory_;
  const SurfaceCell* whole_ = nullptr;  ///< that is searched, if it is no edge
  std::size_t reach_searches_ = 0;
  bool may_split_;
  CellOutcome out_;
};

}  // namespace

double CertificateTask::goal(double low_mm) const {
  if (request.decides_only) return deciding_mm();
  return low_mm + (draws ? draws->gap_mm : 0) +
         kShare * wanted_width_mm(request, low_mm, limit_mm(), errors_mm);
}

CellOutcome search_cell(const CertificateTask& task, std::size_t index, const CellOutcome& before,
                        const model::RunControl& control, const std::shared_ptr<FarPasses>& far) {
  return task.with_cell(
      index, [&](const auto& cell) { return CellSearch(task, before, control, far).run(cell); });
}

}  // namespace limitgauge::verifier
