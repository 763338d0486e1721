#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "model/base/run_control.h"
#include "verifier/gate/stage_pieces.h"

namespace limitgauge::app {

/// A step of a run, for those who watch it.
struct Phase {
  std::string what;        ///< "finish: cutting"
  std::size_t stage = 0;   ///< counted from 1; 0 for what belongs to no stage
  std::size_t stages = 0;  ///< of the whole job
};

/// How a run is watched. Neither call changes a result.
struct RunWatch {
  /// A phase begins; its progress follows through `progress`.
  std::function<void(const Phase&)> phase = [](const Phase&) {};
  std::function<void(double fraction)> progress = [](double) {};
  /// A line for those who want to know more.
  std::function<void(const std::string&)> note = [](const std::string&) {};
};

struct RunOptions {
  unsigned threads = 1;
  const std::atomic<bool>* stop = nullptr;
  RunWatch watch;
  std::string label;    ///< of the run, or empty; stands in the result as it is
  std::string created;  ///< ISO 8601, UTC; stands in the result as it is
  /// False: no files of stages are written, and the result has no figures of them.
  bool stage_files = true;
  /// Who does pieces of measuring the stage whose pass is the last of these; empty: this process
  /// does all.
  std::function<std::unique_ptr<verifier::PieceWorkers>(std::span<const model::Pass>)> share = {};
};

/// What the parts of a run's stage tell those who watch it, and hear from them.
struct StageWatch {
  const RunOptions& options;
  std::size_t stage = 0;   ///< the one at work, counted from 1; 0: none
  std::size_t stages = 0;  ///< of the whole job

  /// Says that `what` begins. Throws Interrupted.
  model::RunControl control(const std::string& what) const {
    options.watch.phase({what, stage, stages});
    model::RunControl control{options.threads, options.stop, options.watch.progress};
    control.check();
    return control;
  }
};

}  // namespace limitgauge::app
