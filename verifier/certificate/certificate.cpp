#include "verifier/certificate/certificate.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <span>

#include "model/base/chunks.h"
#include "verifier/certificate/run_bounds.h"

namespace limitgauge::verifier {
namespace {

/// Cells of the first batch, and of the largest: the first ones show what there is to be found, and
/// the last ones keep all threads busy.
constexpr std::size_t kFirstBatch = 16, kLargestBatch = 4096;

/// The run at every cell's middle; but for uncut a lower bound of it, which tells the large ones as
/// well there.
std::vector<double> looks_of(const CertificateTask& task, const model::RunControl& control) {
  std::vector<double> looks(task.size());
  constexpr std::size_t kChunk = 256;
  model::parallel_chunks(looks.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    RunBounds bounds(task.cells, task.space, task.side, task.request.allowance_mm);
    std::optional<BodyRef> hint;
    for (std::size_t i = begin; i < end; ++i)
      looks[i] = task.with_cell(i, [&](const auto& cell) {
        const auto [m, n] = middle_of(cell);
        return task.side == Side::uncut ? bounds.run(m, n).length_mm : bounds.quick_run(m, n, hint);
      });
  });
  return looks;
}

/// The longest of those that count, traced to its end.
void see_longest(const CertificateTask& task, const std::vector<double>& looks,
                 const std::vector<std::size_t>& order, CellOutcome& out) {
  RunBounds bounds(task.cells, task.space, task.side, task.request.allowance_mm, task.draws);
  for (const std::size_t i : order) {
    if (looks[i] <= 0) return;
    const bool found = task.with_cell(i, [&](const auto& cell) {
      const auto [m, n] = middle_of(cell);
      const SurfacePlace place = place_of(cell, m);
      if (!task.counts(cell, place, n)) return false;
      const TracedRun run = bounds.run(m, n);
      const bool by_run = task.side != Side::uncut && run.body;
      out.see({place, run.length_mm, by_run ? *run.body : bounds.nearest_body(m), n, run.shift_x,
               run.shift_y});
      return true;
    });
    if (found) return;
  }
}

/// Searches some cells, each from what was found before. Neighbours, whose numbers are near to each
/// other, one after the other, as many for any number of threads: they ask about the same moves.
std::vector<CellOutcome> search_batch(const CertificateTask& task,
                                      std::span<const std::size_t> cells, const CellOutcome& before,
                                      const model::RunControl& control) {
  constexpr std::size_t kMostNeighbours = 32, kLeastChunks = 64;
  std::vector<std::size_t> places(cells.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::sort(places.begin(), places.end(),
            [&](std::size_t a, std::size_t b) { return cells[a] < cells[b]; });
  std::vector<CellOutcome> found(cells.size());
  const std::size_t chunk =
      std::clamp<std::size_t>(cells.size() / kLeastChunks, 1, kMostNeighbours);
  model::parallel_chunks(places.size(), chunk, control, [&](std::size_t begin, std::size_t end) {
    const auto far = std::make_shared<FarPasses>();
    for (std::size_t i = begin; i < end; ++i)
      found[places[i]] = search_cell(task, cells[places[i]], before, control, far);
  });
  return found;
}

/// Whether what is left need not be looked at.
bool is_decided(const CertificateTask& task, const CellOutcome& found) {
  return task.request.decides_only && task.settled(found.low);
}

Interval interval_of(const CellOutcome& out, double errors_mm) {
  return {std::max(0.0, out.low - errors_mm),
          std::max({0.0, out.high + errors_mm, out.low - errors_mm})};
}

}  // namespace

Certificate certify(const SurfaceCells& cells, const RemovedSpace& space, Side side,
                    const ReachQuery* reach, const CertificateRequest& request,
                    const model::RunControl& control, const Draws* draws) {
  const CertificateTask task{cells, space, side, reach, request, kRounding_mm, draws};
  const std::vector<double> looks = looks_of(task, control);
  std::vector<std::size_t> order(looks.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return looks[i] > looks[j]; });
  CellOutcome sum;
  if (request.decides_only) sum.low = task.deciding_mm();
  see_longest(task, looks, order, sum);
  std::size_t batch = kFirstBatch;
  for (std::size_t at = 0; at < order.size() && !is_decided(task, sum); at += batch) {
    batch = std::clamp(at / 4, kFirstBatch, kLargestBatch);
    control.check();
    control.report(static_cast<double>(at) / static_cast<double>(order.size()));
    const std::size_t count = std::min(batch, order.size() - at);
    const auto found = search_batch(task, std::span(order).subspan(at, count), sum, control);
    for (const CellOutcome& o : found) sum.merge(o);
  }
  if (is_decided(task, sum)) sum.cover(std::numeric_limits<double>::infinity());
  if (request.decides_only && !sum.witness) sum.low = 0;
  Certificate out;
  out.figure_mm = interval_of(sum, task.errors_mm);
  out.witness = sum.witness;
  out.cells = sum.cells;
  out.reached_resolution = out.figure_mm.width() <= request.resolution_mm;
  return out;
}

}  // namespace limitgauge::verifier
