#pragma once

#include "app/job/job.h"

namespace limitgauge::app {

/// Refuses lengths that nothing of this job can be divided or measured by: those beyond the extent
/// of cage and stock, and a voxel that no cutter of the stages fills. Throws InputError that names
/// the key, its value and what would do. Needs no surface, so that it can come before all work;
/// `cage` is null for a job without a design.
void require_fit(const Job& job, const model::Cage* cage);

}  // namespace limitgauge::app
