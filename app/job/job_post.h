#pragma once

#include "app/job/job.h"
#include "app/job/job_parts.h"
#include "app/toml/toml_table.h"

namespace limitgauge::app {

/// [machine]: rates and clearance. What is left to a default is said in `context`.
void read_machine(const TomlTable& root, Job& job, JobContext& context);
/// [post]: how programs of planned stages are written. To be read after the stages: without a
/// planned one, no default is worth saying.
void read_post(const TomlTable& root, Job& job, JobContext& context);

}  // namespace limitgauge::app
