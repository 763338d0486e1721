#pragma once

#include "app/cli/commands.h"

namespace limitgauge::app {

/// Prints what a program is: its canonical moves, one a line, or a summary of them.
void inspect_program(const InspectCommand& command, const CommonOptions& common,
                     const Console& console);

}  // namespace limitgauge::app
