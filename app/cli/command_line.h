#pragma once

#include "app/cli/command.h"
#include "app/cli/usage_error.h"
#include "app/usage/command_reference.h"

namespace limitgauge::app {

struct CommandLine {
  Command command;
  CommonOptions common;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// Everything that the command line takes, from the definitions that parse it.
CommandReference command_reference();

}  // namespace limitgauge::app
