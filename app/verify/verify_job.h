#pragma once

#include "app/cli/command_line.h"

namespace limitgauge::app {

/// The job that a `verify` command asks for: one stage, or one for each tool that the program loads
/// where several are stated; the limits are the last one's. Throws UsageError for an option that
/// cannot be understood, InputError for files that cannot be read.
Job job_of(const VerifyCommand& command);

}  // namespace limitgauge::app
