#include "engine/model/gcode/machine_state.h"

#include <cmath>

#include "engine/model/words.h"

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
  refresh();
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
