#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/part/toolpath.h"
#include "verifier/gate/stage_pieces.h"

namespace limitgauge::app {

/// What a worker is not told by the job: where a run stands when it measures a stage.
struct SharedStage {
  std::string job_key;  ///< CaseKeys::result of the job: its text, its files, the program
  std::size_t stage = 0;
  std::vector<std::shared_ptr<const model::Toolpath>> paths;  ///< of all stages up to it
  std::vector<std::shared_ptr<const model::ToolAxes>> axes;   ///< one a path; null: upright
};
std::string to_bytes(const SharedStage& shared);
/// Nothing for bytes that are not what to_bytes() makes.
std::optional<SharedStage> shared_stage_of(std::string_view bytes);

/// A piece to be worked out, by the keys of what it is made of.
struct PieceTask {
  std::string stage_key;  ///< of a SharedStage in the store
  std::string reach_key;  ///< of the reach map there; empty as long as there is none
  verifier::StagePiece piece;
};
std::vector<std::string> words_of(const PieceTask& task);
std::optional<PieceTask> piece_task_of(std::span<const std::string> words);

/// Kinds of entries: SharedStage, reach map, what a piece came to.
inline constexpr const char *kStageKind = "stage", *kReachKind = "reach", *kPieceKind = "result";
/// Of what the piece comes to.
std::string piece_key(const PieceTask& task);

}  // namespace limitgauge::app
