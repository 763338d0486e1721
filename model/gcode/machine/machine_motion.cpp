#include "model/gcode/machine/machine_motion.h"

#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

const Word& code_of(const Statement& statement) {
  return *statement.g_word(GGroup::non_modal);
}

/// Z of the tip where the spindle stands at `spindle_z_mm`.
double tip_z(const Statement& statement, const MachineState& state, double spindle_z_mm,
             Assumptions& assumed) {
  const auto length_mm = state.tools.true_length();
  if (!length_mm)
    assumed.add(statement.line(),
                "machine coordinates along Z are taken to be the tip's: the"
                " length of the tool in the spindle is not stated");
  return spindle_z_mm - length_mm.value_or(0);
}

/// Z of the tip for Z of the machine in a block of G53: that of the spindle, or where the control
/// keeps the length of the tool in force, of what the program calls the tip.
double tip_z_of_g53(const Statement& statement, const MachineState& state, double z_mm,
                    Assumptions& assumed) {
  if (!statement.rules().length_in_machine_frame || !state.tools.has_offset_in_use())
    return tip_z(statement, state, z_mm, assumed);
  assumed.add(statement.line(),
              "the tool's length is taken to stay in effect in a block of G53, G153 or SUPA; a "
              "control may be set to leave it out there");
  return z_mm + state.tools.shift_mm();
}

/// Whether machine coordinates of `axis` mean anything in the active frame. Turned, both X and Y
/// need both.
bool is_stated(const MachineState& state, int axis) {
  const CoordinateSystem& system = state.systems.system();
  if (axis == 2 || system.rotation_deg == 0) return system.stated[axis];
  return system.stated[0] && system.stated[1];
}

bool parks(const Statement& statement, const MachineState& state, bool rapid) {
  const Word* const z = statement.word('Z');
  return rapid && z && z->value == 0 && !statement.word('X') && !statement.word('Y') &&
         !is_stated(state, 2);
}

void check_g53(const Statement& statement, const MachineState& state, bool rapid) {
  if (state.modal.incremental)
    statement.fail(code_of(statement), "G53 in incremental distance mode (G91)", "G90");
  if (!statement.has_axes())
    statement.fail(code_of(statement), "G53 without an axis word", "X, Y or Z");
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    if (!word || is_stated(state, axis)) continue;
    statement.fail(*word,
                   in_quotes(word->text) + " in machine coordinates, while nothing states where " +
                       state.systems.name() + " lies on the machine",
                   std::string(kOffsetRemedy) + (rapid ? ", or G0 G53 Z0 alone" : ""));
  }
}

bool moves(const Statement& statement, int axis) {
  return !statement.has_axes() || statement.word(kAxes[axis]);
}

/// Whether a stored position leads anywhere in the active frame. Throws where the machine states
/// one and nothing says what that is in the frame.
bool leads_somewhere(const Statement& statement, const MachineState& state,
                     const ReferencePoint& point, int axis) {
  if (!point.known[axis]) return false;
  if (point.from_program || is_stated(state, axis)) return true;
  const std::string code(code_of(statement).text);
  statement.fail(code_of(statement),
                 code + " leads " + kAxes[axis] +
                     " to a reference point that is stated, while nothing states where " +
                     state.systems.name() + " lies on the machine",
                 kOffsetRemedy);
}

void check_astray(const Statement& statement, const MachineState& state) {
  if (state.adrift[2]) return;
  for (int axis = 0; axis < 2; ++axis) {
    if (!state.adrift[axis]) continue;
    statement.fail(code_of(statement),
                   std::string(code_of(statement).text) + " moves " + kAxes[axis] +
                       " while the height is known to be in the work; its reference point is not"
                       " stated",
                   "Z before it, or the reference point in the machine's setup");
  }
}

}  // namespace

Vec3 machine_end(const Statement& statement, MachineState& state, bool rapid,
                 Assumptions& assumed) {
  forbid_compensation(statement, code_of(statement), state);
  if (statement.has_rotary() && !statement.has_axes()) return state.position_mm;
  if (!state.modal.incremental && parks(statement, state, rapid)) {
    state.adrift[2] = true;
    assumed.add(statement.line(), "Z0 in machine coordinates is taken to be above everything");
    return state.position_mm;
  }
  check_g53(statement, state, rapid);
  if (const Word* z = statement.word('Z'); z && (state.adrift[0] || state.adrift[1]))
    statement.fail(*z, "Z comes down while nothing states where X and Y are", "X and Y first");
  Vec3 tip_mm = state.frame.to_machine(state.position_mm);
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    if (!word) continue;
    const double to_mm = length_of(statement, *word, state);
    tip_mm[axis] = axis == 2 ? tip_z_of_g53(statement, state, to_mm, assumed) : to_mm;
    state.known[axis] = true;
    state.adrift[axis] = false;
  }
  if (state.fresh)
    assumed.add(statement.line(), state.systems.name() + " lies where a fresh machine has it");
  return state.frame.to_work(tip_mm);
}

Vec3 reference_end(const Statement& statement, MachineState& state, Assumptions& assumed) {
  const bool first = statement.g(GGroup::non_modal) == 280;
  const ReferencePoint& point = state.reference[first ? 0 : 1];
  const std::string name = first ? "G28" : "G30";
  Vec3 tip_mm = point.at_mm;
  if (point.from_program) {
    tip_mm.z -= state.tools.true_length().value_or(0);
  } else if (moves(statement, 2) && leads_somewhere(statement, state, point, 2)) {
    tip_mm.z = tip_z(statement, state, tip_mm.z, assumed);
  }
  const Vec3 stored_mm = state.frame.to_work(tip_mm);
  Vec3 end_mm = state.position_mm;
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves(statement, axis)) continue;
    state.adrift[axis] = !leads_somewhere(statement, state, point, axis);
    if (state.adrift[axis]) continue;
    end_mm[axis] = stored_mm[axis];
    state.known[axis] = true;
  }
  check_astray(statement, state);
  if (moves(statement, 2) && state.adrift[2])
    assumed.add(statement.line(), name + " is taken to lead Z above everything");
  if (state.fresh && !point.from_program)
    assumed.add(statement.line(), "the reference point of " + name + " lies at the machine's zero");
  return end_mm;
}

void store_reference(const Statement& statement, MachineState& state) {
  forbid_compensation(statement, code_of(statement), state);
  const bool first = statement.g(GGroup::non_modal) == 281;
  Vec3 at_mm = state.frame.to_machine(state.position_mm);
  at_mm.z += state.tools.true_length().value_or(0);
  ReferencePoint& point = state.reference[first ? 0 : 1];
  point = {at_mm, state.known, true, state.orientation.angles_deg};
  for (int axis = 0; axis < 3; ++axis) {
    if (state.fresh) point.known[axis] = true;
    if (state.adrift[axis]) point.known[axis] = false;
  }
}

}  // namespace limitgauge::model::gcode
