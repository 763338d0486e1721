#pragma once

#include "app/job/job_parts.h"

namespace limitgauge::app {

/// What programs take from the machine and where they lie: `work_offsets`, `home` and `second_home`
/// of [machine], [program_frame], and the tools that have numbers.
void read_setup(const TomlTable& root, const TomlTable& machine, Job& job);
/// The tools that have a number, as the machine's tool table.
std::vector<model::ToolEntry> tool_table(const std::vector<JobTool>& tools);

}  // namespace limitgauge::app
