#pragma once

#include <span>
#include <string>

#include "app/cli/command.h"
#include "app/job/job.h"

namespace limitgauge::app {

/// The job that a `cut` command asks for, without a design: one stage, or one for each tool that
/// the program loads where several are stated. Throws UsageError for an option that cannot be
/// understood, InputError for files that cannot be read.
Job job_of(const CutCommand& command);
/// The same against a design; the limits are the last stage's.
Job job_of(const VerifyCommand& command);

/// Replaces keys of the job that the options of `verify` or `cut` make, each `dotted.key=value` as
/// for a job file; its stages have the names that its folders have: "program", or "T1" and so on.
/// What only the options can say (cage, stock, tools, program, fixtures) is refused with the
/// option's name, and so is what needs a design where the job has none. Throws InputError that
/// names the override.
void apply_verify_overrides(Job& job, std::span<const std::string> overrides);

}  // namespace limitgauge::app
