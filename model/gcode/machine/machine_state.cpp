#include "model/gcode/machine/machine_state.h"

#include <cmath>

#include "model/base/angle.h"
#include "model/gcode/control/control_rules.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

ReferencePoint stated_point(const std::optional<Vec3>& at_mm, bool fresh) {
  if (!at_mm && !fresh) return {};
  return {at_mm.value_or(Vec3{}), {true, true, true}, false};
}

}  // namespace

MachineState::MachineState(const MachineSetup& machine)
    : systems(machine),
      tools(machine),
      reference{stated_point(machine.home_mm, machine.assume_fresh_machine),
                stated_point(machine.second_home_mm, machine.assume_fresh_machine)},
      fresh(machine.assume_fresh_machine) {
  if (rules_of(machine.control).begins_in_g0) modal.motion = modal.beside_cycles = 0;
  modal.motion_is_taken = modal.motion.has_value();
  modal.return_to_r = !rules_of(machine.control).begins_in_g98;
  orientation.machine = machine.kinematics;
  orientation.tool_centred = machine.starts_tool_centred.value_or(false);
  orientation.control_is_assumed = !machine.starts_tool_centred.has_value();
  refresh();
  if (!machine.start_mm) return;
  has_start = true;
  start_mm = *machine.start_mm;
  known.fill(!machine.start_is_assumed);
  position_mm = frame.to_work(systems.frame(0).to_machine(*machine.start_mm));
}

void MachineState::take_place(int axis, double value_mm) {
  Vec3 shift_mm;
  shift_mm[axis] = value_mm - position_mm[axis];
  start_mm += turned(shift_mm, frame.rotation_deg - systems.system(0).rotation_deg);
  position_mm[axis] = value_mm;
  known[axis] = true;
}

void MachineState::refresh() {
  frame = systems.frame(systems.active());
  frame.length_offset_mm = tools.shift_mm();
  // Along the tool then, wherever it points (MotionFrame::length_error_mm).
  if (orientation.tool_centred) frame.length_offset_mm = 0;
}

MotionFrame MachineState::motion_frame() const {
  MotionFrame out;
  if (orientation.plane) {
    out.control = TipControl::tool_centre;
    Pose work = turn_about({0, 0, 1}, frame.rotation_deg);
    const Vec3 length_mm{0, 0, frame.length_offset_mm};
    work.shift_mm = frame.to_machine({}) - length_mm;
    Pose along_tool;
    along_tool.shift_mm = length_mm;
    out.plane = work * *orientation.plane * along_tool;
  } else if (orientation.tool_centred) {
    out.control = TipControl::tool_centre;
    out.length_error_mm = tools.shift_mm();
  } else if (orientation.dynamic_offset) {
    out.control = TipControl::dynamic_offset;
    out.work_zero_mm = frame.to_machine({}) - Vec3{0, 0, frame.length_offset_mm};
  } else if (orientation.machine && orientation.machine->has_head()) {
    out.tool_length_mm = tools.true_length().value_or(0);
  }
  return out;
}

Vec3 MachineState::in_workpiece() const {
  const Vec3 place_mm = orientation.plane ? position_mm : frame.to_machine(position_mm);
  return motion_frame()
      .in_workpiece(orientation.machine.value(), orientation.angles_deg)
      .point(place_mm);
}

Vec3 MachineState::tip_mm() const {
  return orientation.machine ? in_workpiece() : frame.to_machine(position_mm);
}

void MachineState::lower_tip(std::uint32_t line, double by_mm) {
  if (by_mm == 0 || adrift[2] || keeps_tip_at_change()) return;
  if (orientation.machine) {
    const Vec3 up = orientation.machine->stand({}, orientation.angles_deg, 0).axis;
    stand_at(tip_mm() - up * by_mm, motion_frame());
  } else {
    position_mm = frame.to_work(frame.to_machine(position_mm) - Vec3{0, 0, by_mm});
  }
  if (has_moved) moved_tip = TipPlace{0, line, tip_mm(), orientation.angles_deg};
}

void MachineState::keeping_tip(const std::function<void()>& change) {
  const Frame before = frame;
  const MotionFrame motions_before = motion_frame();
  const Vec3 tip_before_mm = tip_mm();
  change();
  refresh();
  stay_at(before);
  if (!orientation.machine) return;
  const MotionFrame now = motion_frame();
  const bool is_along_tool = orientation.tool_centred && !(now == motions_before);
  if (is_along_tool || now.tool_length_mm != motions_before.tool_length_mm)
    stand_at(tip_before_mm, motions_before);
}

void MachineState::keeping_tool(const std::function<void()>& change) {
  const Vec3 tip_before_mm = in_workpiece();
  const MotionFrame before = motion_frame();
  change();
  refresh();
  stand_at(tip_before_mm, before);
}

void MachineState::stand_at(const Vec3& tip_mm, const MotionFrame& before) {
  const Kinematics& machine = orientation.machine.value();
  const MotionFrame now = motion_frame();
  const Pose from_motion = now.in_workpiece(machine, orientation.angles_deg);
  const Vec3 place_mm = from_motion.point_back(tip_mm);
  position_mm = orientation.plane ? place_mm : frame.to_work(place_mm);
  const Pose change = from_motion.inverse() * before.in_workpiece(machine, orientation.angles_deg);
  if (!change.turns()) return;
  if (!(known[0] && known[1] && known[2])) known = {};
  if (is_adrift()) adrift.fill(true);
}

void MachineState::stay_at(const Frame& before) {
  if (frame == before) return;
  position_mm = frame.to_work(before.to_machine(position_mm));
  if (frame.rotation_deg == before.rotation_deg) return;
  // Each of X and Y becomes a mixture of both.
  known[0] = known[1] = known[0] && known[1];
  adrift[0] = adrift[1] = adrift[0] || adrift[1];
}

bool names_place(const Statement& statement, ArcPlane plane) {
  const auto [first, second, along] = axes_of(plane);
  return statement.word("XYZ"[first]) || statement.word("XYZ"[second]);
}

void forbid_compensation(const Statement& statement, const Word& word, const MachineState& state) {
  if (!state.is_compensated()) return;
  statement.fail(word,
                 in_quotes(word.text) + " while cutter compensation is on (G" +
                     std::to_string(state.modal.compensation / 10) + ")",
                 "G40 before it");
}

double length_of(const Statement& statement, const Word& word, const MachineState& state) {
  const double length_mm = word.value * state.modal.unit_mm;
  if (!(std::abs(length_mm) <= kLargestCoordinateMm))
    statement.fail(word, in_quotes(word.text) + " is beyond any machine", "at most 1e9 mm");
  return length_mm;
}

}  // namespace limitgauge::model::gcode
