#include "model/gcode/read/orientation_codes.h"

#include <cmath>
#include <string>

#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {
namespace {

/// Some 2,700 turns; a typing error beyond.
constexpr double kMostDegrees = 1e6;

double angle_word(const Statement& statement, char letter) {
  const Word* const word = statement.word(letter);
  return word ? word->value : 0;
}

void refuse_while(const Statement& statement, const Word& word, bool active, const char* mode,
                  const char* expected) {
  if (active) statement.fail(word, in_quotes(word.text) + " while " + mode, expected);
}

/// The angles, of the ways within the limits the nearest, that put the tool along `axis` of the
/// workpiece, which is `named` in the message where there are none.
RotaryAngles angles_along(const Statement& statement, const Word& word, const MachineState& state,
                          const Vec3& axis, const char* named, const char* expected) {
  const Orientation& orientation = state.orientation;
  const auto angles = orientation.machine->angles_for(axis, orientation.angles_deg);
  if (!angles)
    statement.fail(word,
                   std::string("no angles of the rotary axes within their limits put the tool "
                               "along ") +
                       named + "(" + six_digits(axis.x) + ", " + six_digits(axis.y) + ", " +
                       six_digits(axis.z) + ") of the workpiece",
                   expected);
  return *angles;
}

/// Where I, J and K put the tool, of the active work frame; left out, each is 0 (Fanuc A-79348EN).
RotaryAngles vector_end(const Statement& statement, const MachineState& state) {
  const Word& word = *statement.first_of({'I', 'J', 'K'});
  const Vec3 named{angle_word(statement, 'I'), angle_word(statement, 'J'),
                   angle_word(statement, 'K')};
  const Vec3 way = state.frame.to_machine(named) - state.frame.to_machine({});
  constexpr double kLeast = 1e-6, kMost = 1e9;
  if (!(length(way) > kLeast && length(way) < kMost))
    statement.fail(word, "I, J and K are no direction", "the tool's axis, from the tip up");
  return angles_along(statement, word, state, normalized(way), "",
                      "an axis that the machine reaches");
}

}  // namespace

const Word* turning_word(const Statement& statement, const MachineState& state) {
  if (const Word* rotary = statement.first_of({'A', 'B', 'C'})) return rotary;
  return state.orientation.by_vector ? statement.first_of({'I', 'J', 'K'}) : nullptr;
}

RotaryAngles rotary_end(const Statement& statement, const MachineState& state) {
  if (state.orientation.by_vector && statement.first_of({'I', 'J', 'K'}))
    return vector_end(statement, state);
  RotaryAngles end = state.orientation.angles_deg;
  for (const char letter : {'A', 'B', 'C'}) {
    const Word* const word = statement.word(letter);
    if (!word) continue;
    double& angle = end[static_cast<std::size_t>(letter - 'A')];
    angle = word->value + (state.modal.incremental ? angle : 0);
    if (!(std::abs(angle) <= kMostDegrees))
      statement.fail(*word, in_quotes(word->text) + " turns an axis beyond counting",
                     "at most 1e6 degrees");
  }
  return end;
}

void require_length(const Statement& statement, const Word& word, const MachineState& state) {
  const Orientation& orientation = state.orientation;
  if (!orientation.machine->has_head() || state.tools.true_length()) return;
  statement.fail(
      word, in_quotes(word.text) + " turns a head, and the length of the tool in it is not stated",
      "\"length\" of the tool in the job, from the spindle's gauge line to the tip");
}

void leave_tool_centre(const Statement& statement, MachineState& state) {
  Orientation& orientation = state.orientation;
  if (!orientation.tool_centred || statement.rules().control == Control::linuxcnc) return;
  state.keeping_tool([&] { orientation.tool_centred = orientation.by_vector = false; });
}

void forbid_in_tool_centre(const Statement& statement, const MachineState& state) {
  refuse_while(statement, *statement.g_word(GGroup::length_offset), state.orientation.tool_centred,
               "places are the tip's (G43.4, G234)", "G49 before it");
}

void enter_tool_centre(const Statement& statement, MachineState& state, Assumptions& assumed) {
  Orientation& orientation = state.orientation;
  const Word& word = *statement.g_word(GGroup::length_offset);
  refuse_while(statement, word, orientation.plane.has_value(), "a working plane is tilted (G68.2)",
               "G69 before it");
  refuse_while(statement, word, orientation.dynamic_offset, "a dynamic offset is on (G254)",
               "G255 before it");
  require_length(statement, word, state);
  state.keeping_tool([&] { orientation.tool_centred = true; });
  if (!orientation.frame_is_told && orientation.machine->kind != MachineKind::head_head)
    assumed.add(statement.line(), std::string(word.text) +
                                      " is taken to count in the workpiece as it lies with the "
                                      "rotary axes at 0 (a control's parameter may say otherwise)");
  orientation.frame_is_told = true;
  orientation.by_vector = statement.g(GGroup::length_offset) == 435;
  if (orientation.by_vector)
    assumed.add(statement.line(),
                "I, J and K under G43.5 are taken to turn the axes, of the ways within their "
                "limits the nearest, evenly while the tip goes straight");
}

void check_tool_vector(const Statement& statement, const MachineState& state, bool on_arc) {
  if (!state.orientation.by_vector) return;
  if (const Word* rotary = statement.first_of({'A', 'B', 'C'}))
    statement.fail(*rotary, in_quotes(rotary->text) + " while I, J and K turn the tool (G43.5)",
                   "I, J and K, or G43.4 in place of G43.5");
  const Word* const centre = statement.first_of({'I', 'J', 'K'});
  if (centre && statement.g_word(GGroup::length_offset))
    statement.fail(*centre, in_quotes(centre->text) + " beside a length offset",
                   "a block of its own behind it");
  if (centre && on_arc)
    statement.fail(*centre,
                   in_quotes(centre->text) +
                       " of an arc while I, J and K are the tool's axis "
                       "(G43.5)",
                   "R for the arc's radius");
}

void switch_kinematics(const Statement& statement, MachineState& state) {
  const auto code = statement.m(MGroup::kinematics);
  if (!code) return;
  const Word& word = *statement.m_word(MGroup::kinematics);
  forbid_compensation(statement, word, state);
  if (*code == 430)
    statement.fail(word, "M430 switches to kinematics of the machine's owner",
                   "M428 (the tip's places) or M429 (joints)");
  Orientation& orientation = state.orientation;
  refuse_while(statement, word, orientation.plane.has_value(), "a working plane is tilted (G68.2)",
               "G69 before it");
  if (*code == 428) require_length(statement, word, state);
  state.keeping_tool([&] { orientation.tool_centred = *code == 428; });
  orientation.control_is_assumed = false;
}

void set_working_plane(const Statement& statement, MachineState& state, Assumptions& assumed) {
  const auto code = statement.g(GGroup::working_plane);
  if (!code) return;
  const Word& word = *statement.g_word(GGroup::working_plane);
  Orientation& orientation = state.orientation;
  if (*code == 690) {
    if (!orientation.plane) return;
    forbid_compensation(statement, word, state);
    return state.keeping_tool([&] { orientation.plane.reset(); });
  }
  forbid_compensation(statement, word, state);
  refuse_while(statement, word, orientation.plane.has_value(), "another working plane is tilted",
               "G69 before it");
  refuse_while(statement, word, orientation.tool_centred,
               "places are the tip's (G43.4, G234, M428)", "G49 or M429 before it");
  refuse_while(statement, word, orientation.dynamic_offset, "a dynamic offset is on (G254)",
               "G255 before it");
  Pose plane = turn_about({0, 0, 1}, angle_word(statement, 'I')) *
               turn_about({1, 0, 0}, angle_word(statement, 'J')) *
               turn_about({0, 0, 1}, angle_word(statement, 'K'));
  for (int axis = 0; axis < 3; ++axis)
    if (const Word* place = statement.word(kAxes[axis]))
      plane.shift_mm[axis] = length_of(statement, *place, state);
  state.keeping_tool([&] { orientation.plane = plane; });
  assumed.add(statement.line(),
              "G68.2 is taken to count in the workpiece as it lies with the rotary axes at 0, I, J "
              "and K to be Euler's angles about Z, X and Z");
}

void set_dynamic_offset(const Statement& statement, MachineState& state) {
  const auto code = statement.g(GGroup::dynamic_offset);
  if (!code) return;
  const Word& word = *statement.g_word(GGroup::dynamic_offset);
  Orientation& orientation = state.orientation;
  forbid_compensation(statement, word, state);
  if (*code == 2550) return state.keeping_tool([&] { orientation.dynamic_offset = false; });
  refuse_while(statement, word, orientation.machine->has_head(), "the machine's head turns",
               "G43.4 or G234");
  refuse_while(statement, word, orientation.tool_centred || orientation.plane.has_value(),
               "G234 or G68.2 is on", "G49 or G69 before it");
  state.keeping_tool([&] { orientation.dynamic_offset = true; });
}

RotaryAngles plane_angles(const Statement& statement, const MachineState& state,
                          Assumptions& assumed) {
  const Word& word = *statement.g_word(GGroup::non_modal);
  const Orientation& orientation = state.orientation;
  if (!orientation.plane)
    statement.fail(word, "G53.1 without a tilted working plane", "G68.2 before it");
  if (statement.has_axes() || statement.has_rotary())
    statement.fail(word, "G53.1 beside axis words", "a block of its own");
  require_length(statement, word, state);
  const Vec3 axis = state.motion_frame().plane.direction({0, 0, 1});
  const RotaryAngles angles = angles_along(statement, word, state, axis, "Z of the tilted plane, ",
                                           "a plane that the machine reaches");
  assumed.add(statement.line(), "G53.1 is taken to turn to " +
                                    orientation.machine->to_text(angles, " ") +
                                    ", of the ways within the limits the nearest");
  return angles;
}

void check_frame_is_free(const Statement& statement, const Word& word, const MachineState& state) {
  const Orientation& orientation = state.orientation;
  if (const Word* rotary = statement.first_of({'A', 'B', 'C'});
      rotary && !statement.is_set_aside(*rotary) && (rotary->value != 0 || orientation.is_turned()))
    statement.fail(*rotary, "an offset of a rotary axis is not carried out", "X, Y and Z");
  refuse_while(statement, word, orientation.plane.has_value(), "a working plane is tilted (G68.2)",
               "G69 before it");
  refuse_while(statement, word, orientation.dynamic_offset, "a dynamic offset is on (G254)",
               "G255 before it");
}

}  // namespace limitgauge::model::gcode
