#include "app/job/setup_frame.h"

namespace limitgauge::app {

model::MachineSetup machine_in_setup(const Job& job, std::size_t setup) {
  model::MachineSetup machine = job.machine;
  const auto& own = job.setups[setup].machine;
  if (!own) return machine;
  machine.work_offsets = own->work_offsets;
  machine.extended_offsets = own->extended_offsets;
  return machine;
}

model::RigidPlacement machine_in_setup_frame(const Job& at_setup) {
  return model::machine_in_part(
      at_setup.program_frame, at_setup.machine.work_offsets.front().value_or(model::WorkOffset()));
}

model::Pose turned_body(const Job& at_setup, const FixtureMount& mount,
                        const model::RotaryAngles& angles_deg) {
  const model::Kinematics& machine = at_setup.machine.kinematics.value();
  const model::Pose placed = pose_of(machine_in_setup_frame(at_setup));
  const model::Pose upright = machine.upright(angles_deg) * machine.table(angles_deg).inverse();
  model::Pose carried = machine.table(angles_deg);
  if (mount.kind == FixtureMount::Kind::machine) carried = {};
  if (mount.kind == FixtureMount::Kind::axis) carried = machine.carried_by(mount.axis, angles_deg);
  return placed * upright * carried * placed.inverse();
}

model::Pose body_in_tool(const std::optional<model::Kinematics>& machine, const FixtureMount& mount,
                         const model::RotaryAngles& angles_deg, double tool_length_mm) {
  model::Pose from_gauge;
  from_gauge.shift_mm.z = tool_length_mm;
  if (mount.kind == FixtureMount::Kind::spindle) return from_gauge;
  const model::Kinematics& heads = machine.value();
  return from_gauge * heads.head(angles_deg).inverse() *
         heads.head_carrying(mount.axis.value(), angles_deg);
}

}  // namespace limitgauge::app
