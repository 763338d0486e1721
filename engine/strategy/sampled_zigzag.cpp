#include "engine/strategy/sampled_zigzag.h"

#include <utility>

#include "engine/strategy/boundary_pass.h"
#include "engine/strategy/row_passes.h"
#include "engine/strategy/sampled_rows.h"

namespace limitgauge::engine::strategy {

StagePath plan_sampled_zigzag(const surface::FinishModel& model, const StageRequest& request,
                              const model::RunControl& control) {
  const LimitLocations limit = limit_locations(model.patches(), request);
  DriveRows made = make_sampled_rows(limit, request, control);
  StagePath stage;
  stage.planes = static_cast<int>(made.rows.size());
  set_intervals(stage, std::move(made.sampling_intervals));
  std::vector<std::vector<CutPass>> groups(1);
  for (DriveRow& row : made.rows)
    for (auto& run : row.runs) groups.front().push_back(row_pass(std::move(run), request));
  if (request.cut.boundary_pass)
    groups.push_back(boundary_passes(model.patches(), limit, request, control));
  stage.path = link_passes(groups, limit.surface, request, control);
  return stage;
}

}  // namespace limitgauge::engine::strategy
