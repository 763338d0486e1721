#pragma once

#include <string>

#include "app/job/job.h"
#include "app/job/job_parts.h"
#include "app/toml/toml_table.h"

namespace limitgauge::app {

/// Keys of a stage that say how it is cut, whatever the strategy.
inline constexpr const char* kCutKeys[] = {"step",          "scallop",   "tolerance",   "feed",
                                           "plunge_feed",   "link_feed", "floor",       "angle",
                                           "pattern",       "direction", "steep_angle", "overlap",
                                           "boundary_pass", "entry",     "ramp_angle"};

/// How the stage `name` is to be cut. What is left to a default is said in `context`; a key that
/// the strategy does not use is an error: it would change nothing.
StagePlan read_plan(const TomlTable& stage, const std::string& name, JobContext& context);

}  // namespace limitgauge::app
