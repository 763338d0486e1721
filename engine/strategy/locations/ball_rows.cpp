#include "engine/strategy/locations/ball_rows.h"

#include <algorithm>
#include <cstddef>

#include "engine/strategy/linking/least_links.h"
#include "engine/strategy/locations/ball_sections.h"
#include "engine/strategy/rows/row_spacing.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

constexpr std::size_t kRowsAChunk = 16;

/// The run, nowhere lower than `floor`.
std::vector<PlanePoint> raised(const std::vector<PlanePoint>& run, double floor) {
  std::vector<PlanePoint> line;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const PlanePoint& b = run[i];
    if (i > 0 && (run[i - 1].z < floor) != (b.z < floor)) {
      const PlanePoint& a = run[i - 1];
      line.push_back({a.s + (b.s - a.s) * ((floor - a.z) / (b.z - a.z)), floor});
    }
    line.push_back({b.s, std::max(b.z, floor)});
  }
  return line;
}

std::vector<CentreRow> centre_rows(const BallSections& sections, const CutOptions& cut,
                                   const model::RunControl& control) {
  if (cut.scallop_mm) return scallop_rows(sections, cut, control);
  return rows_at(sections, even_rows(sections, cut.step_mm), control);
}

DriveRow tip_row(const CentreRow& row, const StageRequest& request, const DriveFrame& frame) {
  const double radius = request.cutter.radius_mm();
  DriveRow tips{row.across_mm, {}};
  for (const auto& run : row.centre.runs) {
    tips.runs.emplace_back();
    for (const PlanePoint& p : least_links(raised(run, request.floor_z_mm + radius),
                                           kRowReductionShare * request.cut.tolerance_mm))
      tips.runs.back().push_back(frame.to_part({p.s, row.across_mm, p.z - radius}));
  }
  return tips;
}

}  // namespace

DriveRows make_ball_rows(const surface::FinishModel& model, const StageRequest& request,
                         const model::RunControl& control) {
  const DriveFrame frame(request.cut.angle_deg);
  const BallSections sections(model.patches(), request, frame, control);
  const std::vector<CentreRow> rows = centre_rows(sections, request.cut, control);
  DriveRows result{std::vector<DriveRow>(rows.size()), sections.sampling_intervals()};
  model::parallel_chunks(rows.size(), kRowsAChunk, control,
                         [&](std::size_t begin, std::size_t end) {
                           for (std::size_t i = begin; i < end; ++i)
                             result.rows[i] = tip_row(rows[i], request, frame);
                         });
  return result;
}

}  // namespace limitgauge::engine::strategy
