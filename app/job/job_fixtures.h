#pragma once

#include "app/job/job_parts.h"

namespace limitgauge::app {

/// The fixtures of `[[fixture]]`: name, file, translate. Throws InputError for a file that is not
/// there and for a second fixture of one name.
void read_fixtures(const TomlTable& root, Job& job, const JobContext& context);
/// `travel = { x = [low, high], ... }` of [machine]: an axis that is not named has no limit.
model::Box3 read_travel(const TomlTable& machine);

}  // namespace limitgauge::app
