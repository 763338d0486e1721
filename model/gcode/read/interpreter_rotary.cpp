// The interpreter's part for rotary axes.
#include "model/gcode/read/interpreter.h"

#include <algorithm>
#include <cmath>

#include "model/gcode/cycles/canned_cycle_parameters.h"
#include "model/gcode/read/motion_codes.h"
#include "model/gcode/read/orientation_codes.h"
#include "model/gcode/text/word_use.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {

/// Whether a word of the block that turns the tool says more than how it stands already.
bool Interpreter::turns(const Statement& statement) const {
  return turning_word(statement, state_) != nullptr &&
         rotary_end(statement, state_) != state_.orientation.angles_deg;
}

void Interpreter::check_turn(const Statement& statement, std::optional<int> motion) const {
  check_tool_vector(statement, state_, motion && is_arc(*motion));
  const Word* const turning = turning_word(statement, state_);
  if (!turning) return;
  const Word& word = *turning;
  // G68.2 takes the axis words of a place, which rotary ones are not.
  const bool is_taken = axes_are_taken(statement) && statement.g(GGroup::working_plane) != 682;
  if (!motion && !is_taken)
    statement.fail(word, in_quotes(word.text) + " beside no motion", "G0 or G1");
  if (!motion || !turns(statement)) return;
  forbid_compensation(statement, word, state_);
  if (is_canned_cycle(*motion))
    statement.fail(word, in_quotes(word.text) + " turns an axis in a canned cycle",
                   "G0 or G1 before it");
  const Orientation& orientation = state_.orientation;
  const bool on_arc = *motion != 0 && *motion != 10;
  if (orientation.dynamic_offset)
    statement.fail(word, in_quotes(word.text) + " turns an axis under a dynamic offset (G254)",
                   "G255 before it");
  if (orientation.plane && on_arc)
    statement.fail(
        word,
        in_quotes(word.text) + " turns an axis on an arc while a working plane is tilted (G68.2)",
        "G0 or G1 before it");
  if (orientation.plane && statement.has_axes())
    statement.fail(
        word, in_quotes(word.text) + " beside X, Y or Z while a working plane is tilted (G68.2)",
        "a block of its own, or G53.1");
  require_length(statement, word, state_);
}

/// Which places motions name from here on, where that has changed.
void Interpreter::note_frame() {
  if (!state_.orientation.machine) return;
  FrameChange now{program_.motions.size(), state_.orientation.angles_deg, state_.motion_frame()};
  if (!program_.frames.empty()) {
    FrameChange& last = program_.frames.back();
    if (last.angles_deg == now.angles_deg && last.frame == now.frame) return;
    if (last.motion == now.motion) return void(last = now);
  }
  program_.frames.push_back(now);
}

/// Whether all motions so far have ended at that height.
bool Interpreter::keeps_height(double z_mm) const {
  return std::all_of(program_.motions.begin(), program_.motions.end(),
                     [z_mm](const Motion& motion) { return motion.to.z == z_mm; });
}

void Interpreter::list_turn(const Statement& statement, const Motion& motion,
                            const TurningMotion& turn) {
  Orientation& orientation = state_.orientation;
  if (program_.turns.empty())
    assumed_.add(statement.line(),
                 "the rotary axes are taken to have stood at 0 before the first line");
  const Control control = statement.rules().control;
  if (program_.turns.empty() && (control == Control::fanuc || control == Control::haas))
    assumed_.add(statement.line(),
                 "A, B and C are taken to be degrees with and without a decimal point, and axes to "
                 "go to the angle that is named, not by a shorter way round (parameters of the "
                 "control say otherwise)");
  if (orientation.control_is_assumed && statement.rules().control == Control::linuxcnc)
    assumed_.add(statement.line(),
                 "X, Y and Z are taken to be joints while axes turn (identity kinematics): neither "
                 "M428, M429 nor [machine] tool_centred says which");
  // Before Z is named, it stands where the start is taken to be, unless it was moved from there.
  const bool is_above = motion.parked || (!motion.height_known && keeps_height(motion.to.z));
  if (is_above)
    assumed_.add(statement.line(),
                 "an axis turns while Z is taken to stand above everything: nothing is within the "
                 "tool's reach");
  orientation.control_is_assumed = false;
  program_.turns.push_back({program_.motions.size() - 1, statement.line(),
                            motion.kind == MotionKind::rapid, motion.spindle_stopped, is_above,
                            turn});
  orientation.angles_deg = turn.to_deg;
}

/// LinuxCNC's: a feed is of X, Y and Z, and where they stand still, degrees a minute.
double Interpreter::minutes_of(const Statement& statement, const Motion& motion, double way_mm,
                               const TurningMotion& turn) const {
  if (motion.kind == MotionKind::rapid || motion.feed_mm_min == 0) return 0;
  if (state_.modal.feed_mode == FeedMode::inverse_time) return 1 / statement.word('F')->value;
  const double feed_mm_min = static_cast<double>(motion.feed_mm_min);
  if (way_mm > 0) return way_mm / feed_mm_min;
  double squares = 0;
  for (std::size_t i = 0; i < turn.to_deg.size(); ++i)
    squares += (turn.to_deg[i] - turn.from_deg[i]) * (turn.to_deg[i] - turn.from_deg[i]);
  return std::sqrt(squares) * state_.modal.unit_mm / feed_mm_min;
}

/// What the last turn's words say wherever the axes stood before it.
void Interpreter::note_named(const Statement& statement) {
  if (state_.modal.incremental || state_.orientation.by_vector) return;
  for (const char letter : {'A', 'B', 'C'})
    if (statement.word(letter))
      program_.turns.back().named[static_cast<std::size_t>(letter - 'A')] = true;
}

/// G0 to G3 with a rotary word that turns: what X, Y and Z name goes evenly with the angles.
void Interpreter::turn(const Statement& statement, int code) {
  if (state_.orientation.plane)
    return turn_in_joints(statement, rotary_end(statement, state_), code == 0);
  TurningMotion turn;
  turn.frame = state_.motion_frame();
  const Vec3 from_mm = state_.position_mm;
  turn.from_mm = state_.frame.to_machine(from_mm);
  turn.from_deg = state_.orientation.angles_deg;
  turn.to_deg = rotary_end(statement, state_);
  const bool straight = code == 0 || code == 10, was_parked = state_.adrift[2];
  const Motion motion = straight ? straight_motion(statement, state_, code == 0, assumed_)
                                 : arc_motion(statement, state_, code == 30);
  check_park(statement, was_parked, turn.to_deg);
  emit(statement, motion);
  turn.to_mm = state_.frame.to_machine(state_.position_mm);
  list_turn(statement, program_.motions.back(), turn);
  program_.turns.back().minutes =
      minutes_of(statement, motion, motion_length_mm(motion, from_mm), turn);
  note_named(statement);
}

/// Straight to `to_mm` in the active frame, while the rotary axes go to `to_deg`.
void Interpreter::go_to(const Statement& statement, const Vec3& to_mm, const RotaryAngles& to_deg,
                        bool rapid) {
  TurningMotion turn;
  turn.frame = state_.motion_frame();
  turn.from_mm = state_.frame.to_machine(state_.position_mm);
  turn.from_deg = state_.orientation.angles_deg;
  turn.to_deg = to_deg;
  Motion motion;
  motion.kind = rapid ? MotionKind::rapid : MotionKind::feed;
  motion.plane = state_.modal.plane;
  motion.to = state_.position_mm = to_mm;
  emit(statement, motion);
  if (turn.to_deg == turn.from_deg) return;
  turn.to_mm = state_.frame.to_machine(to_mm);
  list_turn(statement, program_.motions.back(), turn);
}

/// The rotary axes alone, while X, Y and Z stand still on the machine whatever the control counts.
void Interpreter::turn_in_joints(const Statement& statement, const RotaryAngles& to_deg,
                                 bool rapid) {
  if (to_deg == state_.orientation.angles_deg) return;
  in_joints([&] { go_to(statement, state_.position_mm, to_deg, rapid); });
}

void Interpreter::set_tip_control(const Statement& statement) {
  if (!state_.orientation.machine) return;
  switch_kinematics(statement, state_);
  set_working_plane(statement, state_, assumed_);
  set_dynamic_offset(statement, state_);
}

/// Where G28 and G30 send the rotary axes that they name, or all where they name none, by way of
/// `by_deg`: to where G28.1 and G30.1 found them, or to 0.
RotaryAngles Interpreter::turn_home(const Statement& statement, const RotaryAngles& by_deg) {
  const Orientation& orientation = state_.orientation;
  RotaryAngles home_deg = by_deg;
  if (!orientation.machine) return home_deg;
  const bool all = !statement.has_axes() && !statement.has_rotary();
  const ReferencePoint& point = state_.reference[statement.g(GGroup::non_modal) == 280 ? 0 : 1];
  for (const RotaryAxis& axis : orientation.machine->axes)
    if (all || statement.word(axis.word)) home_deg[axis.index()] = point.angles_deg[axis.index()];
  if (by_deg == orientation.angles_deg && home_deg == by_deg) return home_deg;
  require_length(statement, *statement.g_word(GGroup::non_modal), state_);
  if (!point.from_program)
    assumed_.add(statement.line(), "the reference points of the rotary axes are taken to be at 0");
  return home_deg;
}

/// A head that is turned takes Z aside as it goes up; lying down, it takes the tool nowhere above.
/// And while Z is on its way to a place that nothing states, axes that turn to `to_deg` meanwhile
/// may meet the tool anywhere.
void Interpreter::check_park(const Statement& statement, bool was_parked,
                             const RotaryAngles& to_deg) const {
  const Orientation& orientation = state_.orientation;
  if (!state_.adrift[2] || !orientation.machine) return;
  if (!was_parked && to_deg != orientation.angles_deg)
    statement.fail(statement.blamed(), "axes turn while Z is sent to a place that nothing states",
                   "Z in a block of its own before it, or the reference point ([machine] home) and "
                   "the work offset in the job");
  constexpr double kLeast = 0.1;  // of the way goes up along the tool: 84 degrees
  if (orientation.machine->head(orientation.angles_deg).direction({0, 0, 1}).z >= kLeast) return;
  statement.fail(statement.blamed(),
                 "Z is sent to a place that nothing states while the head lies down",
                 "the reference point ([machine] home) and the work offset in the job, or the head "
                 "upright before it");
}

}  // namespace limitgauge::model::gcode
