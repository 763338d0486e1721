#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "study/execute/executor.h"
#include "study/store/store.h"
#include "verifier/gate/stage_pieces.h"

namespace limitgauge::app {

/// How a run that shares out its measuring goes on.
struct SharedPiecesOptions {
  EngineOptions engine;
  std::filesystem::path job;           ///< absolute
  std::vector<std::string> overrides;  ///< `key=value`
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> note = [](const std::string&) {};
  std::function<void(double)> progress = [](double) {};
};

/// Has pieces of a run's stages worked out on Slurm. What was come to is kept in the cache, so that
/// a run that is repeated takes it up.
class SharedPieces {
 public:
  /// Throws model::InputError where this machine has no Slurm or the cache cannot be written,
  /// ResourceError where Slurm does not answer, Interrupted.
  explicit SharedPieces(SharedPiecesOptions options);

  /// For the stage whose pass is the last of these. It must not outlive this.
  std::unique_ptr<verifier::PieceWorkers> of_stage(std::span<const model::Pass> passes);

 private:
  class OfStage;
  SharedPiecesOptions options_;
  study::Store store_;
  std::string job_key_;
  std::unique_ptr<study::Executor> executor_;
};

}  // namespace limitgauge::app
