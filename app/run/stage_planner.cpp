#include "app/run/stage_planner.h"

#include <algorithm>
#include <stdexcept>

#include "app/inputs/stock_file.h"
#include "app/job/settings.h"
#include "engine/strategy/strategies.h"
#include "model/base/error.h"
#include "verifier/certificate/leftover_regions.h"

namespace limitgauge::app {

engine::surface::ModelRequest model_request(const Job& job) {
  engine::surface::ModelRequest request;
  if (job.design) request.precision_mm = job.design->precision_mm;
  for (const JobStage& stage : job.stages) {
    // Only rows of a ball move the surface out; they keep away by their tolerance at most beyond.
    if (!stage.plan || stage.plan->cut.strategy != engine::strategy::Strategy::zigzag ||
        stage.cutter.type != model::CutterType::ball)
      continue;
    request.largest_offset_mm =
        std::max(request.largest_offset_mm,
                 stage.cutter.radius_mm() + stage.allowance_mm + stage.plan->cut.tolerance_mm);
  }
  return request;
}

const engine::surface::FinishModel& StagePlanner::finish_model(const model::RunControl& control) {
  if (!model_) model_.emplace(inputs_.design.value().cage, model_request(job_), control);
  is_used_ = true;
  return *model_;
}

const std::optional<engine::surface::FinishModel>& StagePlanner::expected_model(
    const model::RunControl& control) {
  const auto planned = [](const JobStage& stage) { return stage.plan.has_value(); };
  if (model_ || std::none_of(job_.stages.begin(), job_.stages.end(), planned)) return model_;
  try {
    model_.emplace(inputs_.design.value().cage, model_request(job_), control);
  } catch (const std::invalid_argument&) {
    // The stage that cannot be planned says so when its turn comes.
  }
  return model_;
}

engine::strategy::StageRequest StagePlanner::request(std::size_t stage) const {
  const JobStage& asked = job_.stages[stage];
  engine::strategy::StageRequest request;
  request.cut = asked.plan->cut;
  request.cutter = asked.cutter;
  request.allowance_mm = asked.allowance_mm;
  request.clearance_mm = job_.clearance_mm;
  request.rapid_mm_min = job_.rapid_mm_min;
  request.floor_z_mm = inputs_.settings.floor_z_mm[stage];
  request.stock = planned_stock(job_.stock);
  return request;
}

/// What the stages before have left that this one's cutter can take away.
std::vector<model::Box3> StagePlanner::regions(std::size_t stage,
                                               std::span<const verifier::Pass> before,
                                               const model::RunControl& control) const {
  const JobStage& asked = job_.stages[stage];
  verifier::LeftoverRequest leftover;
  leftover.cutter = asked.cutter;
  leftover.allowance_mm = asked.allowance_mm;
  leftover.threshold_mm = rest_threshold_mm(asked);
  leftover.tile_mm = std::max(leftover.tile_mm, 2 * asked.plan->cut.step_mm);
  return find_leftover_regions(inputs_.design.value().surface, job_.stock, before, leftover,
                               control)
      .boxes;
}

StageToCut StagePlanner::plan_own(std::size_t stage, std::span<const verifier::Pass> before,
                                  const model::RunControl& control) {
  PlannedStage planned;
  try {
    engine::strategy::StageRequest asked = request(stage);
    if (asked.cut.strategy == engine::strategy::Strategy::rest)
      asked.regions = regions(stage, before, control);
    planned.path = plan_stage(finish_model(control), asked, control);
  } catch (const std::invalid_argument& error) {
    throw model::InputError({}, "stage \"" + job_.stages[stage].name + "\": " + error.what(),
                            "a stage that a path can serve");
  }
  write_stage_program(job_, stage, inputs_.settings.chord_error_mm[stage], planned);
  StageToCut ready;
  ready.path = std::make_shared<const model::Toolpath>(std::move(planned.path.path));
  ready.program = std::make_shared<const std::string>(std::move(planned.program));
  ready.cl_data = std::move(planned.cl_data);
  ready.figures = std::move(planned.path);
  return ready;
}

StageToCut StagePlanner::take_program(std::size_t stage) const {
  const ForeignPath& foreign = *inputs_.programs[stage];
  StageToCut ready{foreign.path, foreign.text, {}, foreign.ignored_words, {}, foreign.axes};
  const std::size_t of_move = sizeof(model::Move) + (foreign.axes ? sizeof(model::Vec3) : 0);
  ready.figures.memory_bytes = foreign.path->moves.size() * of_move;
  return ready;
}

StageToCut StagePlanner::plan(std::size_t stage, std::span<const verifier::Pass> before,
                              const model::RunControl& control) {
  return job_.stages[stage].plan ? plan_own(stage, before, control) : take_program(stage);
}

}  // namespace limitgauge::app
