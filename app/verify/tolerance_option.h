#pragma once

#include <span>
#include <string>

#include "app/job/job.h"
#include "model/part/tolerances.h"

namespace limitgauge::app {

/// What `--tolerance` options state: `zero=X,Y,Z`, `positioning=X,Y,Z`, `path=P`, `runout=R`, and
/// `N:radius=R,length=L,corner_radius=C,flat=F` of the tool with that number, without `N:` of the
/// only one; half widths in mm. Throws UsageError.
model::Tolerances tolerances_of(std::span<const std::string> options,
                                std::span<const JobTool> tools);

}  // namespace limitgauge::app
