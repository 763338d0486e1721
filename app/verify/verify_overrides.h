#pragma once

#include <span>
#include <string>

#include "app/job/job.h"

namespace limitgauge::app {

/// Replaces keys of the job that `verify`'s options make, each `dotted.key=value` as for a job
/// file; its stages have the names that its folders have: "program", or "T1" and so on. What only
/// the options can say (cage, stock, tools, program, fixtures) is refused with the option's name.
/// Throws InputError that names the override.
void apply_verify_overrides(Job& job, std::span<const std::string> overrides);

}  // namespace limitgauge::app
