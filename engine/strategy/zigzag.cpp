#include "engine/strategy/zigzag.h"

#include <utility>

#include "engine/strategy/ball_rows.h"
#include "engine/strategy/boundary_pass.h"
#include "engine/strategy/cut_passes.h"
#include "engine/strategy/sampled_rows.h"

namespace limitgauge::engine::strategy {
StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control) {
  const bool ball = request.cutter.type == model::CutterType::ball;
  const LimitLocations limit = limit_locations(model.patches(), request);
  DriveRows made =
      ball ? make_ball_rows(model, request, control) : make_sampled_rows(limit, request, control);
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
