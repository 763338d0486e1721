#include "engine/strategy/rows/sampled_rows.h"

#include <algorithm>

#include "engine/strategy/rows/row_places.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

constexpr double kLiftShare = 0.2, kAboveShare = 0.1, kReductionShare = 0.15;
constexpr std::size_t kRowsAChunk = 2;

/// An end of a run along the floor touches nothing: the first point that matters is its last.
void trim_front(std::vector<Vec3>& run, double floor) {
  std::size_t keep = 0;
  while (keep + 1 < run.size() && run[keep].z <= floor && run[keep + 1].z <= floor) ++keep;
  run.erase(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(keep));
}

void trim_floor(std::vector<std::vector<Vec3>>& runs, double floor) {
  for (auto& run : runs) {
    trim_front(run, floor);
    std::reverse(run.begin(), run.end());
    trim_front(run, floor);
    std::reverse(run.begin(), run.end());
  }
  std::erase_if(runs, [](const auto& run) { return run.size() < 2; });
}

}  // namespace

TrackRule track_rule(const LimitLocations& limit, const StageRequest& request) {
  const double tolerance = request.cut.tolerance_mm;
  TrackRule rule;
  // Rows see nothing narrower than a step across; neither need they along.
  rule.spacing_mm = std::min(request.cut.step_mm, request.cutter.radius_mm() / 2);
  rule.lift_mm = kLiftShare * tolerance;
  rule.above_mm = kAboveShare * tolerance;
  rule.reduction_mm = kReductionShare * tolerance;
  rule.floor_z_mm = request.floor_z_mm;
  rule.lowest_mm = limit.lowest_contact_mm;
  return rule;
}

DriveRows make_sampled_rows(const LimitLocations& limit, const StageRequest& request,
                            const model::RunControl& control) {
  const RowPlaces places = place_rows(limit, request, control);
  const TrackRule rule = track_rule(limit, request);
  DriveRows made;
  made.sampling_intervals = limit.sampler.intervals();
  made.rows.resize(places.across.size());
  model::parallel_chunks(
      made.rows.size(), kRowsAChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          DriveRow& row = made.rows[i];
          row.across_mm = places.across[i];
          row.runs = track_tips(limit.surface,
                                {places.at(places.along_low, row.across_mm),
                                 places.at(places.along_high, row.across_mm)},
                                rule);
          trim_floor(row.runs, rule.floor_z_mm + rule.lift_mm);
        }
        control.report(static_cast<double>(end) / static_cast<double>(made.rows.size()));
      });
  std::erase_if(made.rows, [](const DriveRow& row) { return row.runs.empty(); });
  return made;
}

}  // namespace limitgauge::engine::strategy
