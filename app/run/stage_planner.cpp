#include "app/run/stage_planner.h"

#include <algorithm>
#include <stdexcept>

#include "app/inputs/stock_file.h"
#include "app/job/settings.h"
#include "engine/strategy/strategies.h"
#include "model/base/error.h"
#include "model/text/number_text.h"
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

namespace {

StageToCut ready_to_cut(PlannedStage planned) {
  StageToCut ready;
  ready.path = std::make_shared<const model::Toolpath>(std::move(planned.path.path));
  if (planned.path.axes)
    ready.axes = std::make_shared<const model::ToolAxes>(std::move(*planned.path.axes));
  planned.path.axes.reset();
  ready.program = std::make_shared<const std::string>(std::move(planned.program));
  ready.cl_data = std::move(planned.cl_data);
  ready.figures = std::move(planned.path);
  return ready;
}

}  // namespace

StageToCut StagePlanner::leaning(std::size_t stage, const engine::strategy::LeaningRows& rows,
                                 double tilt_deg) const {
  PlannedStage planned;
  planned.path = rows.leaning(tilt_deg);
  write_leaning_program(job_, stage, inputs_.settings.chord_error_mm[stage], planned);
  StageToCut ready = ready_to_cut(std::move(planned));
  ready.lean = job_.stages[stage].plan->cut.lean;
  ready.lean->tilt_deg = tilt_deg;
  return ready;
}

/// The first of the grid that nothing speaks against; what is said where there is none is what
/// spoke against the first and the last.
StageToCut StagePlanner::least_tilt(std::size_t stage, const engine::strategy::LeaningRows& rows,
                                    const CollisionProof& proof) const {
  std::string first, last;
  for (const double tilt_deg : tilt_grid()) {
    std::string against;
    try {
      StageToCut ready = leaning(stage, rows, tilt_deg);
      const std::optional<std::string> found = proof(ready);
      if (!found) return ready;
      against = *found;
    } catch (const std::invalid_argument& error) {
      against = error.what();
    }
    last = "at " + model::shortest(tilt_deg) + " degrees, " + against;
    if (first.empty()) first = last;
  }
  throw model::InputError(job_.stages[stage].plan->tilt_place,
                          "no tilt from -60 to 60 degrees in steps of 5 is proven free of "
                          "collisions in stage \"" +
                              job_.stages[stage].name + "\": " + first + "; " + last,
                          "a tool that reaches farther, another lead or angle of the rows");
}

StageToCut StagePlanner::plan_leaning(std::size_t stage, const model::RunControl& control,
                                      const CollisionProof& proof) {
  const StagePlan& plan = *job_.stages[stage].plan;
  try {
    const engine::strategy::LeaningRows rows(finish_model(control), request(stage), control);
    if (plan.tilt_is_auto) return least_tilt(stage, rows, proof);
    return leaning(stage, rows, plan.cut.lean->tilt_deg);
  } catch (const std::invalid_argument& error) {
    throw model::InputError(plan.tilt_place,
                            "stage \"" + job_.stages[stage].name + "\": " + error.what(),
                            "a stage that the machine can cut so");
  }
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
  return ready_to_cut(std::move(planned));
}

StageToCut StagePlanner::take_program(std::size_t stage) const {
  const ForeignPath& foreign = *inputs_.programs[stage];
  StageToCut ready{foreign.path, foreign.text, {}, foreign.ignored_words, {}, foreign.axes, {}};
  const std::size_t of_move = sizeof(model::Move) + (foreign.axes ? sizeof(model::Vec3) : 0);
  ready.figures.memory_bytes = foreign.path->moves.size() * of_move;
  return ready;
}

StageToCut StagePlanner::plan(std::size_t stage, std::span<const verifier::Pass> before,
                              const model::RunControl& control, const CollisionProof& proof) {
  const std::optional<StagePlan>& asked = job_.stages[stage].plan;
  if (asked && asked->cut.lean) return plan_leaning(stage, control, proof);
  return asked ? plan_own(stage, before, control) : take_program(stage);
}

}  // namespace limitgauge::app
