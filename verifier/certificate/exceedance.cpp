#include "verifier/certificate/exceedance.h"

#include <algorithm>

#include "model/base/chunks.h"
#include "verifier/certificate/run_bounds.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Where the middle cannot be touched, smaller parts are not looked at for others that can.
constexpr double kRim_mm = 0.01;
/// Smaller cells are not halved for a narrower place than themselves: beside a wall of standing or
/// missing material the depth jumps, and no bound closes on the line.
constexpr double kNarrowCell_mm = 0.01;
/// Where the normals of an edge have no cone that shrinks, halving ends.
constexpr int kMostHalvings = 60;
/// Cells that a search for a position that touches a place counts as, and a proof that none touches
/// a cell: they take as long as so many do.
constexpr std::size_t kCellsOfTouch = 50, kCellsOfProof = 400;
constexpr std::size_t kSpotChunk = 64;
/// Cells of this radius are spots where their corners exceed the threshold as their middle does.
constexpr double kLargestSpot_mm = 0.4;

class SpotSearch {
 public:
  SpotSearch(const SurfaceCells& cells, const RemovedSpace& space, const ReachQuery* reach,
             const ExceedanceRequest& request, std::size_t cell_limit,
             const model::RunControl& control)
      : bounds_(cells, space, request.side, request.allowance_mm),
        reach_(reach),
        request_(request),
        cell_limit_(cell_limit),
        control_(control) {}

  void run(const SurfaceCell& cell) { search(cell); }
  void run(const RidgeCell& cell) { search_ridge(cell, 0); }
  Exceedance take() { return std::move(out_); }

 private:
  bool is_uncut() const { return request_.side == Side::uncut; }
  double enough() const { return request_.threshold_mm + request_.slack_mm; }

  void search(const SurfaceCell& cell) {
    // Where reach has no proof, a cell may take a millisecond.
    control_.check();
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    if (bounds_.surely_within(offset, enough())) return;
    const TracedRun run = bounds_.run(offset.middle, offset.normal, request_.threshold_mm);
    if (bounds_.surely_within_thin(offset, run, enough())) return;
    const double radius = control_radius(cell.shape, offset.middle);
    const bool exceeds = run.length_mm > request_.threshold_mm;
    const SurfacePlace place = middle_place(cell, offset.middle);
    const bool touched = !is_uncut() || !exceeds || can_be_touched(cell, place, offset.normal);
    if (exceeds && touched && (radius <= request_.spot_radius_mm || exceeds_all_over(cell, radius)))
      return add(place, run, area_mm2(cell.shape), radius);
    if (!touched && (radius <= kRim_mm || surely_unreachable(cell, offset))) return;
    if (!may_split(radius)) return;
    const auto halves = halved(cell);
    search(halves[0]);
    search(halves[1]);
  }

  void search_ridge(const RidgeCell& cell, int depth) {
    control_.check();
    const OffsetCell offset = cell.offset();
    if (bounds_.surely_within(offset, enough())) return;
    const TracedRun run = bounds_.run(offset.middle, offset.normal, request_.threshold_mm);
    const double radius = control_radius(cell.shape, offset.middle);
    const double across = enough() * offset.spread_rad;
    const bool exceeds = run.length_mm > request_.threshold_mm;
    cells_ += exceeds ? kCellsOfTouch : 0;
    const bool touched = exceeds && reach_->ridge_can_be_touched(offset.middle, offset.normal);
    if (touched && radius <= kLargestSpot_mm) return add(cell.place(), run, 0, radius);
    if (!touched && std::max(radius, across) <= kRim_mm) return;
    if (exceeds && !touched && surely_unreachable(offset)) return;
    if (depth >= kMostHalvings || !may_split(std::max(radius, across))) return;
    const auto halves = cell.halved(request_.allowance_mm + enough());
    search_ridge(halves[0], depth + 1);
    search_ridge(halves[1], depth + 1);
  }

  void add(const SurfacePlace& place, const TracedRun& run, double area_mm2, double radius_mm) {
    const bool by_run = !is_uncut() && run.body;
    out_.spots.push_back({place, run.length_mm, area_mm2, radius_mm,
                          by_run ? *run.body : bounds_.nearest_body(place.point)});
  }

  bool can_be_touched(const SurfaceCell& cell, const SurfacePlace& place, const Vec3& normal) {
    if (!reach_->is_mapped(cell)) cells_ += kCellsOfTouch;
    return reach_->can_be_touched(place, normal);
  }

  bool surely_unreachable(const SurfaceCell& cell, const OffsetCell& offset) {
    if (!reach_->is_mapped(cell)) cells_ += kCellsOfProof;
    return reach_->surely_unreachable(cell, offset, &memory_);
  }
  bool surely_unreachable(const OffsetCell& ridge) {
    cells_ += kCellsOfProof;
    return reach_->ridge_surely_unreachable(ridge, &memory_);
  }

  bool may_split(double radius_mm) {
    if (++cells_ > cell_limit_) out_.complete = false;
    return cells_ <= cell_limit_ && radius_mm >= kNarrowCell_mm;
  }

  /// Looked at in eight places round its middle.
  bool exceeds_all_over(const SurfaceCell& cell, double radius_mm) {
    if (radius_mm > kLargestSpot_mm) return false;
    for (int k = 0; k < 9; ++k) {
      if (k == 4) continue;
      const BezierJet at = jet(cell.shape, (k % 3) / 2.0, (k / 3) / 2.0);
      const Vec3 normal = normalized(cross(at.du, at.dv));
      const TracedRun run = bounds_.run(at.position, normal, request_.threshold_mm);
      if (run.length_mm <= request_.threshold_mm) return false;
      const SurfacePlace place{cell.patch, cell.u_at((k % 3) / 2.0), cell.v_at((k / 3) / 2.0),
                               at.position};
      if (is_uncut() && !reach_->can_be_touched(place, normal)) return false;
    }
    return true;
  }

  RunBounds bounds_;
  const ReachQuery* reach_;
  ReachMemory memory_;
  const ExceedanceRequest& request_;
  std::size_t cells_ = 0, cell_limit_;
  const model::RunControl& control_;
  Exceedance out_;
};

}  // namespace

Exceedance find_exceedance(const SurfaceCells& cells, const RemovedSpace& space,
                           const ReachQuery* reach, const ExceedanceRequest& request,
                           const model::RunControl& control) {
  const std::size_t faces = cells.cells().size();
  const std::size_t count = faces + (request.side == Side::uncut ? cells.ridges().size() : 0);
  const std::size_t chunks = model::chunk_count(count, kSpotChunk);
  std::vector<Exceedance> parts(chunks);
  // Each chunk has its own share of the effort, so that the result does not depend on their order;
  // exceedances are local, so the shares add up to more than the whole.
  constexpr std::size_t kLeastShare = 20'000;
  const std::size_t most = request.largest_cell_count;
  const std::size_t share = std::max(std::min(kLeastShare, most), 4 * most / (chunks + 1));
  model::parallel_chunks(count, kSpotChunk, control, [&](std::size_t begin, std::size_t end) {
    SpotSearch search(cells, space, reach, request, share, control);
    for (std::size_t i = begin; i < end; ++i) {
      if (i < faces)
        search.run(cells.cells()[i]);
      else
        search.run(cells.ridges()[i - faces]);
    }
    parts[begin / kSpotChunk] = search.take();
  });
  Exceedance out;
  for (Exceedance& part : parts) {
    out.complete = out.complete && part.complete;
    out.spots.insert(out.spots.end(), part.spots.begin(), part.spots.end());
  }
  return out;
}

}  // namespace limitgauge::verifier
