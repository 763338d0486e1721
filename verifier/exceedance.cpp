#include "verifier/exceedance.h"

#include <algorithm>
#include <limits>

#include "engine/model/chunks.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Where the middle cannot be touched, smaller parts are not looked at for others that can.
constexpr double kRim_mm = 0.01;
constexpr std::size_t kChunk = 64;

class SpotSearch {
 public:
  SpotSearch(const RemovedSpace& space, const ReachQuery* reach, const ExceedanceRequest& request,
             std::size_t cell_limit, const model::RunControl& control)
      : bounder_(space),
        reach_(reach),
        request_(request),
        cell_limit_(cell_limit),
        control_(control) {}

  void run(const SurfaceCell& cell) {
    std::vector<BodyRef> candidates;
    const double far = request_.side == Side::gouge ? request_.allowance_mm : kInfinite;
    bounder_.find_candidates(cell.shape, candidates, hint_, far);
    if (!candidates.empty()) search(cell, std::move(candidates));
  }
  Exceedance take() { return std::move(out_); }

 private:
  struct Depths {
    double least = 0, here = 0, most = 0;
  };

  Depths depths_of(const CellBounds& b) const {
    const double a = request_.allowance_mm, here = b.nearest.distance.value;
    if (request_.side == Side::gouge) return {a - b.upper, a - here, a - b.lower};
    return {b.lower - a, here - a, b.upper - a};
  }

  void search(const SurfaceCell& cell, std::vector<BodyRef> candidates) {
    // Where reach has no proof, a cell may take a millisecond.
    control_.check();
    const bool gouge = request_.side == Side::gouge;
    const double level = gouge ? request_.allowance_mm - request_.threshold_mm - request_.slack_mm
                               : request_.allowance_mm + request_.threshold_mm;
    const CellBounds b = bounder_.bound(cell.shape, candidates, gouge ? kInfinite : level,
                                        gouge ? level : -kInfinite);
    hint_ = b.nearest.body;
    const Depths depth = depths_of(b);
    if (depth.most <= request_.threshold_mm + request_.slack_mm) return;
    const double radius = control_radius(cell.shape, b.middle);
    const bool spot = depth.here > request_.threshold_mm &&
                      (radius <= request_.spot_radius_mm || depth.least > request_.threshold_mm);
    const SurfacePlace place = middle_place(cell, b.middle);
    const bool touched =
        request_.side == Side::gouge || !spot || reach_->can_be_touched(place, middle_normal(cell));
    if (spot && touched) {
      out_.spots.push_back({place, depth.here, area_mm2(cell.shape), radius, b.nearest.body});
      return;
    }
    if (!touched && (radius <= kRim_mm || reach_->surely_unreachable(cell))) return;
    if (++cells_ > cell_limit_) out_.complete = false;
    if (cells_ > cell_limit_ || radius < kSmallestCell_mm) return;
    const InnerChords chords = inner_chords(cell.shape);
    const auto halves = length(chords.u) >= length(chords.v) ? split_u(cell) : split_v(cell);
    search(halves[0], candidates);
    search(halves[1], std::move(candidates));
  }

  CellBounder bounder_;
  const ReachQuery* reach_;
  const ExceedanceRequest& request_;
  std::size_t cells_ = 0, cell_limit_;
  const model::RunControl& control_;
  std::optional<BodyRef> hint_;
  Exceedance out_;
};

}  // namespace

Exceedance find_exceedance(const SurfaceCells& cells, const RemovedSpace& space,
                           const ReachQuery* reach, const ExceedanceRequest& request,
                           const model::RunControl& control) {
  const std::size_t chunks = model::chunk_count(cells.cells().size(), kChunk);
  std::vector<Exceedance> parts(chunks);
  // Each chunk has its own share of the effort, so that the result does not depend on their order;
  // exceedances are local, so the shares add up to more than the whole.
  constexpr std::size_t kLeastShare = 20'000;
  const std::size_t share = std::max(kLeastShare, 4 * request.largest_cell_count / (chunks + 1));
  model::parallel_chunks(cells.cells().size(), kChunk, control,
                         [&](std::size_t begin, std::size_t end) {
                           SpotSearch search(space, reach, request, share, control);
                           for (std::size_t i = begin; i < end; ++i) search.run(cells.cells()[i]);
                           parts[begin / kChunk] = search.take();
                         });
  Exceedance out;
  for (Exceedance& part : parts) {
    out.complete = out.complete && part.complete;
    out.spots.insert(out.spots.end(), part.spots.begin(), part.spots.end());
  }
  return out;
}

}  // namespace limitgauge::verifier
