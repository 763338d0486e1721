#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "app/inputs/setup_view.h"
#include "app/run/stage_planner.h"
#include "reports/run/run_result.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// The setups of a run: what each stage sees of the job, and all passes so far as they lie in its
/// frame. A job without setups has one, in which the part is not turned. `job` and `inputs` must
/// outlive it.
class RunSetups {
 public:
  /// `model` is the one that the job's first setup would build, where it is at hand.
  RunSetups(const Job& job, const RunInputs& inputs,
            std::optional<engine::surface::FinishModel> model = {});

  const Job& job_at(std::size_t stage) const { return job_of_stage(job_, inputs_, stage); }
  const RunInputs& inputs_at(std::size_t stage) const {
    return inputs_of_stage(job_, inputs_, stage);
  }
  StagePlanner& planner_at(std::size_t stage) { return planners_[setup_of(stage)]; }
  std::size_t setup_of(std::size_t stage) const { return job_.stages[stage].setup; }
  /// From the frame of one stage to that of another.
  model::Pose turn(std::size_t from_stage, std::size_t to_stage) const;

  /// Takes the path of the next stage, in the frame of its setup, and how its tool stands along it
  /// where it turns.
  void add(std::shared_ptr<const model::Toolpath> path,
           std::shared_ptr<const model::ToolAxes> axes);
  std::vector<verifier::Pass> passes_at(std::size_t stage) const;

  /// Of the first setup whose surface was modelled; empty as long as none was.
  std::optional<engine::surface::ModelFigures> figures() const;
  const std::optional<engine::surface::FinishModel>& first_model() const {
    return planners_.front().model();
  }

 private:
  const Job& job_;
  const RunInputs& inputs_;
  std::deque<StagePlanner> planners_;   ///< one a setup
  std::vector<verifier::Pass> passes_;  ///< each in the frame of its own setup
};

/// What was found in a setup's frame, as it lies in the part's.
void to_part_frame(reports::StageRun& ran, const model::Pose& to_part);

/// The fixtures that a page draws about the part, and the names of those that move against it while
/// a stage of the view `at_setup` runs.
void note_fixtures(const Job& at_setup, const RunInputs& inputs, reports::StageRun& ran);

}  // namespace limitgauge::app
