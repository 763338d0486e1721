#pragma once

#include "app/job/job.h"

namespace limitgauge::app {

/// What is to be said of a program that turns its tool, behind its name.
inline constexpr const char* kTurnsInPlace =
    "turns of the tool while its tip stands still are counted without time";

/// Throws InputError for what of `job` does not go with a stage whose tool turns in the part as it
/// cuts: tolerances, limits of travel, fixtures that do not turn with the part.
void require_turning_tool(const Job& job, const JobStage& stage);

/// The same for planned stages whose tool is to lean, and what is needed to post them: rotary axes,
/// a control that has the tip under control, its dialect, the length of a tool in a head.
void require_leaning_stages(const Job& job);

}  // namespace limitgauge::app
