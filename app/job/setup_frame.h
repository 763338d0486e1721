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

/// How a body that goes with the tool lies in the tool's frame (tip at zero, spindle along +Z)
/// while the rotary axes stand at `angles_deg`, the tip being `tool_length_mm` from the gauge line:
/// from its mesh, whose zero is the gauge point with all axes at zero. A machine without rotary
/// axes has none of a head.
model::Pose body_in_tool(const std::optional<model::Kinematics>& machine, const FixtureMount& mount,
                         const model::RotaryAngles& angles_deg, double tool_length_mm);

}  // namespace limitgauge::app
