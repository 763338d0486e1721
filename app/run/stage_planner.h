#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "app/run/stage_program.h"
#include "engine/strategy/axes/leaning_rows.h"
#include "engine/surface/finish_model.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// What the engine's model of the surface is built for: all stages of the job share one.
engine::surface::ModelRequest model_request(const Job& job);

/// What speaks against a stage as it was planned, in words; nothing where it is proven free of
/// collisions.
using CollisionProof = std::function<std::optional<std::string>(const StageToCut&)>;

/// Makes the paths of a job's stages. The engine's model is built at the first stage that needs
/// it, once for all.
class StagePlanner {
 public:
  /// `model` is the one that this job's would be, where it is at hand.
  StagePlanner(const Job& job, const RunInputs& inputs,
               std::optional<engine::surface::FinishModel> model = {})
      : job_(job), inputs_(inputs), model_(std::move(model)), is_used_(model_.has_value()) {}

  /// `before` are the passes of the stages before: a rest stage asks the verifier what they have
  /// left. Throws InputError where the stage asks for something that no path can serve, and where
  /// of a tilt "auto" none of tilt_grid() does for `proof`, which is asked for nothing else.
  StageToCut plan(std::size_t stage, std::span<const verifier::Pass> before,
                  const model::RunControl& control, const CollisionProof& proof = {});
  /// Empty as long as no stage needed it.
  const std::optional<engine::surface::FinishModel>& model() const {
    static const std::optional<engine::surface::FinishModel> kNone;
    return is_used_ ? model_ : kNone;
  }
  /// The one that the first planned stage will need, built for the forecast; empty where none is
  /// planned.
  const std::optional<engine::surface::FinishModel>& expected_model(
      const model::RunControl& control);

 private:
  const engine::surface::FinishModel& finish_model(const model::RunControl& control);
  engine::strategy::StageRequest request(std::size_t stage) const;
  std::vector<model::Box3> regions(std::size_t stage, std::span<const verifier::Pass> before,
                                   const model::RunControl& control) const;
  StageToCut plan_own(std::size_t stage, std::span<const verifier::Pass> before,
                      const model::RunControl& control);
  StageToCut plan_leaning(std::size_t stage, const model::RunControl& control,
                          const CollisionProof& proof);
  StageToCut leaning(std::size_t stage, const engine::strategy::LeaningRows& rows,
                     double tilt_deg) const;
  StageToCut least_tilt(std::size_t stage, const engine::strategy::LeaningRows& rows,
                        const CollisionProof& proof) const;
  StageToCut take_program(std::size_t stage) const;

  const Job& job_;
  const RunInputs& inputs_;
  std::optional<engine::surface::FinishModel> model_;
  bool is_used_ = false;
};

}  // namespace limitgauge::app
