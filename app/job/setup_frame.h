#pragma once

#include "app/job/job.h"

namespace limitgauge::app {

/// The machine with the work offsets of a setup.
model::MachineSetup machine_in_setup(const Job& job, std::size_t setup);
/// The machine's frame in the setup's as it lies with the rotary axes at zero.
model::RigidPlacement machine_in_setup_frame(const Job& at_setup);
/// How a body that is mounted so stands in the setup's frame turned upright, while the rotary axes
/// of `at_setup`'s machine stand at `angles_deg`: from where it stands with them at zero.
model::Pose turned_body(const Job& at_setup, const FixtureMount& mount,
                        const model::RotaryAngles& angles_deg);

}  // namespace limitgauge::app
