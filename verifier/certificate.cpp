#include "verifier/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/model/chunks.h"
#include "verifier/union_depth.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kBatch = 128;
/// Share of all the effort that one cell may take before it is given up, so that one bad spot
/// cannot hold up a run.
constexpr double kShareOfCell = 0.01;
/// Part of the resolution that branch and bound may use; the rest is for rounding.
constexpr double kShare = 0.95;

/// How wide an interval may be whose low end is known so far.
double wanted_width_mm(const CertificateRequest& request, double low_mm, double limit_mm,
                       double errors_mm) {
  constexpr double kSettledShare = 0.05, kFinestShare = 0.01;
  const double asked = request.resolution_mm;
  if (low_mm > limit_mm + errors_mm) return std::max(asked, kSettledShare * low_mm);
  const double room = limit_mm - errors_mm - low_mm;
  return room > 0 && room < asked ? std::max(room, kFinestShare * asked) : asked;
}

/// What is known so far of one figure.
struct Figure {
  double low = 0;
  double high = 0;
  std::optional<Witness> witness;

  void see(double depth_mm, const SurfacePlace& place, BodyRef body) {
    if (depth_mm > low) low = depth_mm, witness = Witness{place, depth_mm, body};
  }
  void cover(double bound_mm) { high = std::max(high, bound_mm); }
  void merge(const Figure& other) {
    if (other.low > low) low = other.low, witness = other.witness;
    high = std::max(high, other.high);
  }
};

struct Outcome {
  Figure gouge, uncut;
  /// The largest a − δ with δ the depth in the union, as far as ways out of it were found: what is
  /// to be covered, where `gouge.low` is what is proven to be reached.
  double gouge_in_union = 0;
  std::size_t cells = 0;
};

/// Up to where a bound need not be improved, by what is known to be reached.
struct Goals {
  const CertificateRequest& request;
  double errors_mm = 0;

  double gouge(double low_mm) const {
    return low_mm + kShare * wanted_width_mm(request, low_mm, request.gouge_limit_mm, errors_mm);
  }
  double uncut(double low_mm) const {
    return low_mm + kShare * wanted_width_mm(request, low_mm, request.uncut_limit_mm, errors_mm);
  }
};

/// Bodies further than this from everything in a cell say nothing of a gouge.
double limit_of_interest(const ReachQuery* reach, const CertificateRequest& request) {
  return reach ? kInfinite : request.allowance_mm;
}

/// First look at a cell of the list.
struct FirstLook {
  CellBounds bounds;
  double gouge_bound = 0, uncut_bound = 0;
};

/// Depth-first refinement of one cell of the list, from what the batches before it have found.
class CellSearch {
 public:
  CellSearch(const RemovedSpace& space, const ReachQuery* reach, const CertificateRequest& request,
             const Goals& goals, const Outcome& before, double longest_mm)
      : bounder_(space),
        depth_(space, longest_mm),
        reach_(reach),
        request_(request),
        goals_(goals) {
    out_.gouge.low = before.gouge.low;
    out_.uncut.low = before.uncut.low;
    out_.gouge_in_union = before.gouge_in_union;
  }

  Outcome run(const SurfaceCell& cell, BodyRef hint) {
    std::vector<BodyRef> candidates;
    bounder_.find_candidates(cell.shape, candidates, hint, limit_of_interest(reach_, request_));
    search(cell, std::move(candidates), true, reach_ != nullptr);
    return out_;
  }
  /// Without refinement: what is known is all there will be.
  Outcome cover(const SurfaceCell& cell, const FirstLook& look) {
    give_up_gouge(cell, look.bounds, look.gouge_bound);
    out_.uncut.cover(look.uncut_bound);
    return out_;
  }

 private:
  void search(const SurfaceCell& cell, std::vector<BodyRef> candidates, bool gouge_open,
              bool uncut_open) {
    ++out_.cells;
    const double a = request_.allowance_mm;
    const double low_enough = uncut_open ? a + uncut_goal() : kInfinite;
    const double high_enough = gouge_open ? a - gouge_goal() : -kInfinite;
    const CellBounds b = bounder_.bound(cell.shape, candidates, low_enough, high_enough);
    const double here = b.nearest.distance.value - a;
    const SurfacePlace place = middle_place(cell, b.middle);
    out_.gouge.see(-here, place, b.nearest.body);
    // Only where the middle itself cannot be touched is there hope to prove it of the whole cell.
    const bool out_of_reach =
        uncut_open && here > out_.uncut.low && !see_uncut(cell, place, here, b.nearest.body);

    const double gouge_bound = a - b.lower, uncut_bound = b.upper - a;
    if (gouge_open && gouge_bound <= gouge_goal()) gouge_open = !covers_union(cell, b);
    if (uncut_open && uncut_bound <= uncut_goal()) {
      out_.uncut.cover(uncut_bound);
      uncut_open = false;
    }
    if (uncut_open && out_of_reach && reach_->surely_unreachable(cell)) uncut_open = false;
    if (!gouge_open && !uncut_open) return;
    const bool tiny = control_radius(cell.shape, b.middle) < kSmallestCell_mm;
    // A spot of a nanometre counts as its middle does: far below the contact tolerance.
    if (uncut_open && out_of_reach && tiny) uncut_open = false;
    if (tiny || static_cast<double>(out_.cells) >
                    kShareOfCell * static_cast<double>(request_.largest_cell_count)) {
      if (gouge_open) give_up_gouge(cell, b, gouge_bound);
      if (uncut_open) out_.uncut.cover(uncut_bound);
      return;
    }
    const auto halves = split_in_u(cell.shape, b) ? split_u(cell) : split_v(cell);
    search(halves[0], candidates, gouge_open, uncut_open);
    search(halves[1], std::move(candidates), gouge_open, uncut_open);
  }

  /// Covers the cell by a bound of the gouge in the union, where δ alone bounds that into one body.
  bool covers_union(const SurfaceCell& cell, const CellBounds& b) {
    const double a = request_.allowance_mm;
    if (b.lower >= 0) {  // outside all bodies δ is the distance itself
      out_.gouge.cover(a - b.lower);
      return true;
    }
    if (depth_.surely_within(cell.shape, b, union_goal() - a)) {
      out_.gouge.cover(union_goal());
      return true;
    }
    const double radius = control_radius(cell.shape, b.middle);
    const UnionDepth::Exit exit = depth_.exit(cell.shape, b, union_goal() - a - radius);
    out_.gouge_in_union = std::max(out_.gouge_in_union, a + exit.length_mm);
    const double bound = a + exit.length_mm + radius;
    if (bound > union_goal() && !depth_.surely_within(cell.shape, exit.direction, union_goal() - a))
      return false;
    out_.gouge.cover(std::min(bound, union_goal()));
    return true;
  }

  void give_up_gouge(const SurfaceCell& cell, const CellBounds& b, double gouge_bound) {
    out_.gouge.cover(gouge_bound);
    if (b.lower >= 0) return;
    const double around = request_.allowance_mm + control_radius(cell.shape, b.middle);
    out_.gouge.cover(around + depth_.exit(cell.shape, b, union_goal() - around).length_mm);
  }

  double gouge_goal() const { return goals_.gouge(out_.gouge.low); }
  /// Where the union is deeper than one body, the interval is that much wider whatever is done:
  /// then a tenth of that more saves most of the effort.
  double union_goal() const {
    constexpr double kShareOfGap = 0.1;
    const double low = out_.gouge.low, known = std::max(low, out_.gouge_in_union);
    const double fine = goals_.gouge(known), coarse = known + kShareOfGap * (known - low);
    const double limit = request_.gouge_limit_mm - goals_.errors_mm;
    const bool decides = known <= limit && coarse > limit;
    return decides ? fine : std::max(fine, coarse);
  }

  double uncut_goal() const { return goals_.uncut(out_.uncut.low); }

  /// Takes the leftover into account if its place can be touched; false if that was not proven.
  bool see_uncut(const SurfaceCell& cell, const SurfacePlace& place, double depth_mm,
                 BodyRef body) {
    if (!reach_->can_be_touched(place, middle_normal(cell))) return false;
    out_.uncut.see(depth_mm, place, body);
    return true;
  }

  /// Split where δ changes most: across the passes far more than along them, but never into
  /// slivers.
  static bool split_in_u(const Bezier& b, const CellBounds& bounds) {
    const InnerChords chords = inner_chords(b);
    const double wide = length(chords.u), tall = length(chords.v);
    if (wide > 8 * tall || tall > 8 * wide) return wide > tall;
    const Vec3& g = bounds.nearest.distance.gradient;
    const double bend_u = std::abs(dot(g, chords.u)), bend_v = std::abs(dot(g, chords.v));
    return bend_u + 0.02 * wide >= bend_v + 0.02 * tall;
  }

  CellBounder bounder_;
  UnionDepth depth_;
  const ReachQuery* reach_;
  const CertificateRequest& request_;
  const Goals& goals_;
  Outcome out_;
};

/// Bounds of every cell of the list, and the best samples among their middles.
std::vector<FirstLook> look_at_all(const SurfaceCells& cells, const RemovedSpace& space,
                                   const ReachQuery* reach, const CertificateRequest& request,
                                   const model::RunControl& control) {
  std::vector<FirstLook> looks(cells.cells().size());
  constexpr std::size_t kChunk = 256;
  model::parallel_chunks(looks.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    CellBounder bounder(space);
    std::vector<BodyRef> candidates;
    std::optional<BodyRef> hint;
    for (std::size_t i = begin; i < end; ++i) {
      const Bezier& shape = cells.cells()[i].shape;
      bounder.find_candidates(shape, candidates, hint, limit_of_interest(reach, request));
      looks[i].bounds.nearest.distance.value = kInfinite;
      if (candidates.empty()) continue;
      looks[i].bounds = bounder.bound(shape, candidates, kInfinite, -kInfinite);
      hint = looks[i].bounds.nearest.body;
      looks[i].gouge_bound = request.allowance_mm - looks[i].bounds.lower;
      if (reach) looks[i].uncut_bound = looks[i].bounds.upper - request.allowance_mm;
    }
  });
  return looks;
}

/// The deepest gouge among the middles.
void see_gouges(const SurfaceCells& cells, const std::vector<FirstLook>& looks, double allowance_mm,
                Figure& gouge) {
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const CellBounds& b = looks[i].bounds;
    gouge.see(allowance_mm - b.nearest.distance.value, middle_place(cells.cells()[i], b.middle),
              b.nearest.body);
  }
}

/// The largest uncut among the middles that can be touched.
void see_uncut(const SurfaceCells& cells, const std::vector<FirstLook>& looks,
               const ReachQuery& reach, double allowance_mm, Figure& uncut) {
  std::vector<std::size_t> order(looks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return looks[i].bounds.nearest.distance.value > looks[j].bounds.nearest.distance.value;
  });
  for (const std::size_t i : order) {
    const CellBounds& b = looks[i].bounds;
    const double depth = b.nearest.distance.value - allowance_mm;
    if (depth <= 0) break;
    const SurfacePlace place = middle_place(cells.cells()[i], b.middle);
    if (!reach.can_be_touched(place, middle_normal(cells.cells()[i]))) continue;
    uncut.see(depth, place, b.nearest.body);
    break;
  }
}

Interval interval_of(const Figure& figure, double allowance_for_errors_mm) {
  return {
      std::max(0.0, figure.low - allowance_for_errors_mm),
      std::max({0.0, figure.high + allowance_for_errors_mm, figure.low - allowance_for_errors_mm})};
}

}  // namespace

Certificate certify(const SurfaceCells& cells, const RemovedSpace& space, const ReachQuery* reach,
                    const CertificateRequest& request, const model::RunControl& control) {
  const std::vector<FirstLook> looks = look_at_all(cells, space, reach, request, control);
  const double errors = kRounding_mm + space.chord_error_mm();
  const Goals goals{request, errors};
  // No gate allows a gouge as deep as the part is large.
  const double longest = length(cells.nodes().front().box.size());
  Outcome sum;
  see_gouges(cells, looks, request.allowance_mm, sum.gouge);
  if (reach) see_uncut(cells, looks, *reach, request.allowance_mm, sum.uncut);
  sum.cells = looks.size();

  const auto excess = [&](const FirstLook& l) {
    return std::max(l.gouge_bound - sum.gouge.low, l.uncut_bound - sum.uncut.low);
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < looks.size(); ++i) order.emplace_back(-excess(looks[i]), i);
  std::sort(order.begin(), order.end());

  for (std::size_t at = 0; at < order.size(); at += kBatch) {
    control.check();
    control.report(static_cast<double>(at) / static_cast<double>(order.size()));
    const std::size_t count = std::min(kBatch, order.size() - at);
    std::vector<Outcome> found(count);
    const Outcome before = sum;
    model::parallel_for(count, control.threads, [&](std::size_t k) {
      const std::size_t i = order[at + k].second;
      const FirstLook& look = looks[i];
      const bool settled = look.bounds.lower >= 0 &&
                           look.gouge_bound <= goals.gouge(before.gouge.low) &&
                           look.uncut_bound <= goals.uncut(before.uncut.low);
      if (settled) {
        found[k].gouge.cover(look.gouge_bound);
        found[k].uncut.cover(look.uncut_bound);
        return;
      }
      CellSearch search(space, reach, request, goals, before, longest);
      found[k] = before.cells > request.largest_cell_count
                     ? search.cover(cells.cells()[i], look)
                     : search.run(cells.cells()[i], look.bounds.nearest.body);
    });
    for (const Outcome& o : found) {
      sum.gouge.merge(o.gouge);
      sum.uncut.merge(o.uncut);
      sum.gouge_in_union = std::max(sum.gouge_in_union, o.gouge_in_union);
      sum.cells += o.cells;
    }
  }

  Certificate out;
  out.gouge_mm = interval_of(sum.gouge, errors);
  out.uncut_mm = interval_of(sum.uncut, errors);
  out.gouge = sum.gouge.witness;
  out.uncut = sum.uncut.witness;
  out.cells = sum.cells;
  out.reached_resolution = out.gouge_mm.width() <= request.resolution_mm &&
                           out.uncut_mm.width() <= request.resolution_mm;
  return out;
}

}  // namespace limitgauge::verifier
