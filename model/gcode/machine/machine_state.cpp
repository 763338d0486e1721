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
}

void MachineState::stay_at(const Frame& before) {
  if (frame == before) return;
  position_mm = frame.to_work(before.to_machine(position_mm));
  if (frame.rotation_deg == before.rotation_deg) return;
  // Each of X and Y becomes a mixture of both.
  known[0] = known[1] = known[0] && known[1];
  adrift[0] = adrift[1] = adrift[0] || adrift[1];
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
