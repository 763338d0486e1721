#pragma once

#include <cstddef>
#include <string>

#include "app/run/pipeline.h"

namespace limitgauge::app {

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
