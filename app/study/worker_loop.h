#pragma once

#include <functional>
#include <string>

#include "app/cli/commands.h"
#include "study/execute/worker_lines.h"

namespace limitgauge::app {

/// Does the tasks of `source` one after the other and answers a line each. From standard input to
/// standard output (`-`) it goes on until its input ends; from a file it answers in a file beside
/// it whose name ends in `.out`. What `run` throws is the answer: ResourceError and want of memory
/// may go better another time, anything else would not. Throws ResourceError for such a file.
ExitCode work_off(const std::string& source,
                  const std::function<void(const study::WorkerTask&)>& run, const Console& console);

}  // namespace limitgauge::app
