#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/cut_stock.h"
#include "engine/surface/finish_model.h"
#include "model/part/toolpath.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::app {

/// A stage that an earlier run has measured: what later stages and result.json take from it.
struct RecordedStage {
  std::shared_ptr<const std::string> json;  ///< reports::recorded_stage of it
  std::shared_ptr<const model::Toolpath> path;
  std::shared_ptr<const std::string> program_text;
  int sampling_interval_min = 1, sampling_interval_max = 1;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  std::shared_ptr<const model::ToolAxes> axes = {};  ///< of a path that turns its tool
};

/// The state of a job after its first stages: what any job that begins with the same ones can go on
/// from. A value, cheap to copy.
struct StagePrefix {
  std::vector<RecordedStage> stages;
  /// Of the engine's model; empty as long as no stage needed it.
  std::optional<engine::surface::ModelFigures> figures;
  /// The model itself, where it is at hand.
  std::optional<engine::surface::FinishModel> model;
  /// What stands, where it is at hand: it can be cut again.
  std::optional<CutStock> stock;

  /// No stage comes after one that did not pass.
  bool over() const { return !stages.empty() && stages.back().verdict != verifier::Verdict::pass; }
  std::size_t memory_bytes() const;
};

/// The stages of `prefix` as bytes for this program on machines of this kind: paths to the last
/// bit, programs, and what was measured. Model and stock are left out.
std::string to_text(const StagePrefix& prefix);
/// Nothing for bytes that are not what to_text() makes.
std::optional<StagePrefix> read_stage_prefix(std::string_view text);

}  // namespace limitgauge::app
