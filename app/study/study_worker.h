#pragma once

#include "app/cli/commands.h"

namespace limitgauge::app {

/// Runs the cases of `command.worker` one after the other, puts their results into the cache and
/// answers a line each. From standard input to standard output (`-`) it goes on until its input
/// ends; from a file it answers in a file beside it whose name ends in `.out`.
ExitCode run_study_worker(const StudyCommand& command, const CommonOptions& common,
                          const Console& console);

}  // namespace limitgauge::app
