#include "app/run/run_setups.h"

namespace limitgauge::app {

RunSetups::RunSetups(const Job& job, const RunInputs& inputs,
                     std::optional<engine::surface::FinishModel> model)
    : job_(job), inputs_(inputs) {
  if (inputs.setups.empty()) planners_.emplace_back(job, inputs, std::move(model));
  for (const auto& at : inputs.setups) planners_.emplace_back(at->job, at->inputs);
}

model::Pose RunSetups::turn(std::size_t from_stage, std::size_t to_stage) const {
  const std::size_t from = setup_of(from_stage), to = setup_of(to_stage);
  if (from == to) return {};
  return job_.setups[to].setup.from_part * job_.setups[from].setup.from_part.inverse();
}

void RunSetups::add(std::shared_ptr<const model::Toolpath> path,
                    std::shared_ptr<const model::ToolAxes> axes) {
  const JobStage& stage = job_.stages[passes_.size()];
  passes_.push_back({stage.cutter, std::move(path), {}, only_positions(stage), std::move(axes)});
}

std::vector<verifier::Pass> RunSetups::passes_at(std::size_t stage) const {
  std::vector<verifier::Pass> passes = passes_;
  for (std::size_t i = 0; i < passes.size(); ++i) passes[i].pose = turn(i, stage);
  return passes;
}

std::optional<engine::surface::ModelFigures> RunSetups::figures() const {
  for (const StagePlanner& planner : planners_)
    if (planner.model()) return planner.model()->figures();
  return std::nullopt;
}

void to_part_frame(reports::StageRun& ran, const model::Pose& to_part) {
  if (to_part == model::Pose{}) return;
  for (simulator::Finding& finding : ran.process) finding.point = to_part.point(finding.point);
  if (ran.deviation) verifier::turn(*ran.deviation, to_part);
}

void note_fixtures(const Job& at_setup, const RunInputs& inputs, reports::StageRun& ran) {
  auto next = inputs.fixtures.begin();
  for (const JobFixture& fixture : at_setup.fixtures) {
    const bool loaded = !fixture.mount.with_tool();
    if (loaded && (!ran.axes || fixture.mount.kind == FixtureMount::Kind::part)) {
      ran.fixtures.push_back(*next);
    } else {
      ran.moving_fixtures.push_back(fixture.name);
    }
    if (loaded) ++next;
  }
}

}  // namespace limitgauge::app
