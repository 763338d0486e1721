#pragma once

#include "app/cli/commands.h"

namespace limitgauge::app {

/// Works out the pieces that `command.engine.worker` names one after the other, puts what they come
/// to into the cache and answers a line each (work_off). Nothing is planned, cut or written.
ExitCode run_piece_worker(const RunCommand& command, const CommonOptions& common,
                          const Console& console);

}  // namespace limitgauge::app
