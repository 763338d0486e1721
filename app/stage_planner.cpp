#include "app/stage_planner.h"

#include <algorithm>
#include <stdexcept>

#include "app/stage_program.h"
#include "engine/model/error.h"

namespace limitgauge::app {

std::optional<engine::surface::ModelFigures> StagePlanner::figures() const {
  if (!model_) return std::nullopt;
  return model_->figures();
}

const engine::surface::FinishModel& StagePlanner::finish_model(const model::RunControl& control) {
  if (model_) return *model_;
  engine::surface::ModelRequest request;
  request.precision_mm = job_.precision_mm;
  for (const JobStage& stage : job_.stages) {
    if (!stage.plan) continue;
    request.largest_offset_mm = std::max(
        request.largest_offset_mm, model::largest_radius_mm(stage.cutter) + stage.allowance_mm);
  }
  model_.emplace(inputs_.cage, request, control);
  return *model_;
}

engine::strategy::StageRequest StagePlanner::request(std::size_t stage) const {
  const JobStage& asked = job_.stages[stage];
  engine::strategy::StageRequest request;
  request.cut = asked.plan->cut;
  request.cutter = asked.cutter;
  request.allowance_mm = asked.allowance_mm;
  request.clearance_mm = job_.clearance_mm;
  request.floor_z_mm = inputs_.settings.floor_z_mm[stage];
  request.stock = job_.stock;
  return request;
}

PlannedStage StagePlanner::plan_own(std::size_t stage, const model::RunControl& control) {
  PlannedStage planned;
  try {
    planned.path = plan_stage(finish_model(control), request(stage), control);
  } catch (const std::invalid_argument& error) {
    throw model::InputError({}, "stage \"" + job_.stages[stage].name + "\": " + error.what(),
                            "a stage that a path can serve");
  }
  write_stage_program(job_, stage, chord_error_mm(inputs_.settings.resolution_mm[stage]), planned);
  return planned;
}

PlannedStage StagePlanner::take_program(std::size_t stage) const {
  const ForeignPath& foreign = *inputs_.programs[stage];
  PlannedStage planned;
  planned.path.path = foreign.path;
  planned.path.memory_bytes = foreign.path.moves.size() * sizeof(model::Move);
  planned.program = foreign.text;
  planned.ignored_words = foreign.ignored_words;
  return planned;
}

PlannedStage StagePlanner::plan(std::size_t stage, const model::RunControl& control) {
  return job_.stages[stage].plan ? plan_own(stage, control) : take_program(stage);
}

}  // namespace limitgauge::app
