// The spindle and the coolant: what S, M3 to M5, M7 to M9, G96 and G97 set, and what motions take
// of it.

#include <algorithm>
#include <utility>

#include "model/gcode/cycles/canned_cycle_parameters.h"
#include "model/gcode/read/interpreter.h"

namespace limitgauge::model::gcode {
namespace {

constexpr double kLargestSpeed = 1e9;

}  // namespace

void Interpreter::set_spindle_mode(const Statement& statement) {
  const auto code = statement.g(GGroup::spindle_mode);
  if (!code) return;
  if (*code == 960 && !statement.word('S'))
    statement.fail(*statement.g_word(GGroup::spindle_mode), "G96 without its surface speed", "S");
  state_.spindle.constant_surface = *code == 960;
}

void Interpreter::set_speed(const Statement& statement) {
  const Word* const s = statement.word('S');
  if (!s) return;
  if (!(s->value >= 0)) statement.fail(*s, "a negative spindle speed", "0 or more");
  if (!(s->value <= kLargestSpeed))
    statement.fail(*s, "a spindle speed beyond any machine", "at most 1e9");
  state_.spindle.rpm = s->value;
}

/// A tool change stops the spindle, and comes before M3 of the same block. A program without M3 and
/// M4 leaves the spindle to the operator; one that starts it somewhere had it at rest before.
void Interpreter::turn_spindle(const Statement& statement) {
  Spindle& spindle = state_.spindle;
  if (statement.m(MGroup::tool_change) == 6 && spindle.on) {
    if (*spindle.on) spindle.stopped_by = "the M6 of line " + std::to_string(statement.line());
    spindle.on = false;
  }
  const auto code = statement.m(MGroup::spindle);
  if (!code) return;
  if (!spindle.on) motions_before_spindle_ = motions_so_far();
  spindle.on = *code == 3 || *code == 4;
  spindle.stopped_by.reset(), spindle.paused_by.reset();
  spindle.clockwise = *code == 3;
  if (!*spindle.on || program_.starts_spindle) return;
  program_.starts_spindle = true;
  const std::size_t out = std::min(motions_before_spindle_, program_.motions.size());
  for (std::size_t i = 0; i < out; ++i) program_.motions[i].spindle_stopped = true;
}

/// M0 and M1. LinuxCNC and Grbl leave the spindle alone; Haas's M0 stops it (96-8000, M00), and M1
/// where the operator has it so; of others the machine's builder decides.
void Interpreter::pause_spindle(const Statement& statement, int code) {
  Spindle& spindle = state_.spindle;
  const Control control = statement.rules().control;
  if (control == Control::linuxcnc || control == Control::grbl || !spindle.on.value_or(false))
    return;
  const std::string by =
      "the M" + std::to_string(code) + " of line " + std::to_string(statement.line());
  if (control == Control::haas && code == 0) {
    spindle.on = false;
    spindle.stopped_by = by;
  } else {
    spindle.paused_by = by;
  }
}

void Interpreter::set_coolant(const Statement& statement) {
  const int code = statement.m(MGroup::coolant).value_or(0);
  if (code == 7) state_.coolant.mist = true;
  if (code == 8) state_.coolant.flood = true;
  if (code == 9) state_.coolant = {};
}

SpindleState Interpreter::spindle_state() const {
  const Spindle& spindle = state_.spindle;
  if (!spindle.on) return SpindleState::unknown;
  if (!*spindle.on) return SpindleState::stopped;
  return spindle.clockwise ? SpindleState::clockwise : SpindleState::counter_clockwise;
}

/// What a feed takes for granted of the spindle.
void Interpreter::note_spindle(const Motion& motion) {
  const Spindle& spindle = state_.spindle;
  if (motion.spindle_stopped) {
    if (spindle.stopped_by)
      assumed_.add(motion.line,
                   "feeds with the spindle at rest: " + *spindle.stopped_by + " has stopped it");
    return;
  }
  if (const auto paused_by = std::exchange(state_.spindle.paused_by, std::nullopt))
    assumed_.add(motion.line, "the spindle is taken to turn behind " + *paused_by +
                                  ", at which a machine may stop it");
  if (!spindle.on.value_or(false)) return;
  if (!spindle.rpm && !std::exchange(lack_of_speed_is_told_, true))
    assumed_.add(motion.line, "the spindle is taken to turn: nothing before says how fast (S)");
  // A tap turns as its cycle says.
  if (!spindle.clockwise && !is_canned_cycle(state_.modal.motion.value_or(0)) &&
      !std::exchange(left_hand_is_told_, true))
    assumed_.add(motion.line,
                 "the cutter is taken to be one that cuts counter-clockwise: M4 turns the spindle");
}

}  // namespace limitgauge::model::gcode
