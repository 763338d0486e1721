#include "engine/strategy/zigzag.h"

#include <utility>

#include "engine/strategy/ball_rows.h"
#include "engine/strategy/boundary_pass.h"
#include "engine/strategy/cut_passes.h"
#include "engine/strategy/row_links.h"
#include "engine/strategy/sampled_rows.h"

namespace limitgauge::engine::strategy {
namespace {

/// Balls need no cutter location surface: their rows say how high a link must go.
StagePath ball_rows_alone(const surface::FinishModel& model, const StageRequest& request,
                          const model::RunControl& control) {
  DriveRows made = make_ball_rows(model, request, control);
  StagePath stage;
  stage.path = link_rows(made, request);
  stage.planes = static_cast<int>(made.rows.size());
  set_intervals(stage, std::move(made.sampling_intervals));
  return stage;
}

}  // namespace

StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control) {
  const bool ball = request.cutter.type == model::CutterType::ball;
  if (ball && !request.cut.boundary_pass) return ball_rows_alone(model, request, control);
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
