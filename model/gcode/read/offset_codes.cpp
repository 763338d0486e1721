#include "model/gcode/read/offset_codes.h"

#include <cmath>

#include "model/base/tolerance.h"
#include "model/gcode/read/orientation_codes.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {
namespace {

const Word& required(const Statement& statement, char letter, const std::string& expected) {
  const Word* const word = statement.word(letter);
  if (!word)
    statement.fail(*statement.g_word(GGroup::non_modal),
                   std::string("G10 without its ") + letter + " word", expected);
  return *word;
}

/// The system that P names beside G10 L2, as Fanuc counts: P0 would move all of them.
std::size_t fanuc_system_of(const Statement& statement) {
  const char* const expected = "P1 to P6 for G54 to G59, L20 P for G54.1 P";
  const Word& p = required(statement, 'P', expected);
  const auto number = whole(p.value, kWholeCount);
  if (number == 0)
    statement.fail(p, "the external offset of all work frames (P0) is not carried out", expected);
  if (!number || *number < 1 || *number > 6)
    statement.fail(p, in_quotes(p.text) + " names no coordinate system", expected);
  return static_cast<std::size_t>(*number - 1);
}

/// The system that P names, as LinuxCNC counts: 0 is the active one.
std::size_t system_of(const Statement& statement, const MachineState& state) {
  if (statement.rules().fanuc_offsets) return fanuc_system_of(statement);
  const char* const expected = "P0 for the active system, P1 to P9 for G54 to G59.3";
  const Word& p = required(statement, 'P', expected);
  const auto number = whole(p.value, kWholeCount);
  if (!number || *number < 0 || *number > static_cast<int>(kWorkOffsets))
    statement.fail(p, in_quotes(p.text) + " names no coordinate system", expected);
  return *number == 0 ? state.systems.active() : static_cast<std::size_t>(*number - 1);
}

void refuse_words(const Statement& statement, std::initializer_list<char> letters,
                  const std::string& code) {
  if (const Word* word = statement.first_of(letters))
    statement.fail(*word, in_quotes(word->text) + " has no meaning beside " + code,
                   "X, Y and Z, beside L2 also R");
}

/// After G10 has set a part of a system that nothing stated.
void check_whole(const Statement& statement, const MachineState& state, std::size_t index) {
  const CoordinateSystem& system = state.systems.system(index);
  if (system.is_usable()) return;
  statement.fail(
      *statement.g_word(GGroup::non_modal),
      "G10 sets a part of " + work_offset_name(index) + ", of which nothing states the rest",
      std::string("X, Y and Z, or ") + kOffsetRemedy);
}

/// LinuxCNC turns the place where it takes the tool to be without the offset of G92; the axis that
/// the next block leaves out would then jump.
void check_turn(const Statement& statement, const Word& r, const MachineState& state,
                std::size_t index) {
  const CoordinateSystems& systems = state.systems;
  if (index != systems.active() || r.value == systems.system().rotation_deg) return;
  const Vec3 g92_mm = systems.frame(index).g92_mm;
  if (g92_mm.x == 0 && g92_mm.y == 0) return;
  statement.fail(r,
                 in_quotes(r.text) + " turns the coordinate system under an offset of G92 or G52",
                 "G92.1 before it");
}

/// G91 adds to the origin on Fanuc, and means nothing to it on LinuxCNC.
double origin_of(const Statement& statement, const Word& word, const MachineState& state,
                 std::size_t index, int axis) {
  const double value_mm = length_of(statement, word, state);
  if (!statement.rules().fanuc_offsets || !state.modal.incremental) return value_mm;
  if (!state.systems.system(index).stated[axis])
    statement.fail(word, "G10 in G91 adds to " + work_offset_name(index) + ", which nothing states",
                   std::string("G90, or ") + kOffsetRemedy);
  return state.systems.system(index).origin_mm[axis] + value_mm;
}

void set_origin(const Statement& statement, MachineState& state, std::size_t index,
                Assumptions& assumed) {
  refuse_words(statement, {'I', 'J', 'Q'}, "G10 L2");
  if (const Word* r = statement.word('R'); r && statement.rules().fanuc_offsets)
    statement.fail(*r, "a turn of the work frame by G10 is LinuxCNC's", "X, Y and Z");
  if (index == state.systems.active())
    forbid_compensation(statement, *statement.g_word(GGroup::non_modal), state);
  const bool taken = state.systems.frame_is_taken();
  state.keeping_tip([&] {
    for (int axis = 0; axis < 3; ++axis) {
      if (const Word* word = statement.word(kAxes[axis]))
        state.systems.state(index, axis, origin_of(statement, *word, state, index, axis));
    }
    if (const Word* r = statement.word('R')) {
      if (!(std::abs(r->value) <= kLargestCoordinateMm))
        statement.fail(*r, "a rotation beyond any use", "degrees");
      check_turn(statement, *r, state, index);
      state.systems.rotate(index, r->value);
    }
  });
  check_whole(statement, state, index);
  if (taken)
    assumed.add(statement.line(), "G10 L2 moves " + work_offset_name(index) +
                                      " from the machine's zero, which is taken to be the part's");
}

/// Whether the tool's place along `axis` can be given another name.
void check_place(const Statement& statement, const Word& word, const MachineState& state,
                 int axis) {
  if (state.adrift[axis])
    statement.fail(
        word,
        in_quotes(word.text) + " sets an offset where nothing states the place of " + kAxes[axis],
        "a motion of that axis to a coordinate first");
}

/// G92 and G10 L20 where the program has not said yet where the tool stands: they say it.
void take_place(const Statement& statement, MachineState& state, int axis, double value_mm,
                Program& program, Assumptions& assumed) {
  state.take_place(axis, value_mm);
  program.start_said_mm[axis] = state.start_mm[axis];
  assumed.add(statement.line(), std::string("the tool stands where ") +
                                    std::string(statement.g_word(GGroup::non_modal)->text) +
                                    " says, " + kAxes[axis] + shortest(value_mm) + " mm of " +
                                    state.systems.name());
}

bool states_place(const MachineState& state, int axis) {
  return !state.known[axis] && !state.fresh && state.systems.system().usable[axis];
}

void touch_system(const Statement& statement, MachineState& state, Program& program,
                  Assumptions& assumed) {
  refuse_words(statement, {'I', 'J', 'Q', 'R'}, "G10 L20");
  const std::size_t index = system_of(statement, state);
  if (index == state.systems.active())
    forbid_compensation(statement, *statement.g_word(GGroup::non_modal), state);
  const bool active = index == state.systems.active();
  std::array<bool, 3> set{};
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    if (!word) continue;
    check_place(statement, *word, state, axis);
    const double value_mm = length_of(statement, *word, state);
    if (active && states_place(state, axis)) {
      take_place(statement, state, axis, value_mm, program, assumed);
    } else if (!state.known[axis] && !state.fresh) {
      statement.fail(*word, "G10 L20 from a place that the program has not stated",
                     "a motion of that axis to a coordinate first");
    } else {
      set[axis] = true;
    }
  }
  Vec3 machine_mm = state.frame.to_machine(state.position_mm);
  machine_mm.z -= state.frame.length_offset_mm;
  Vec3 work_mm = state.systems.frame(index).to_work(machine_mm);
  for (int axis = 0; axis < 3; ++axis) {
    if (set[axis]) work_mm[axis] = length_of(statement, *statement.word(kAxes[axis]), state);
  }
  state.keeping_tip([&] { state.systems.touch(index, machine_mm, work_mm, set); });
  check_whole(statement, state, index);
  if (!active) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (set[axis]) state.position_mm[axis] = work_mm[axis], state.known[axis] = true;
  }
}

void set_tool_data(const Statement& statement, MachineState& state) {
  const char* const expected = "P with a tool's number, and Z or R";
  const Word& p = required(statement, 'P', expected);
  const auto tool = whole(p.value, kWholeCount);
  if (!tool || *tool < 1)
    statement.fail(p, in_quotes(p.text) + " names no tool", "an integer from 1");
  if (const Word* word = statement.first_of({'I', 'J', 'Q'}))
    statement.fail(*word, in_quotes(word->text) + " of a tool is a lathe's", expected);
  for (const char axis : {'X', 'Y'}) {
    if (const Word* word = statement.word(axis); word && word->value != 0)
      statement.fail(*word, "a tool offset along " + std::string(1, axis) + " is not carried out",
                     "0, or Z only");
  }
  const Word *const z = statement.word('Z'), *const r = statement.word('R');
  if (!z && !r)
    statement.fail(p, "G10 L1 without a length and a radius would set nothing", expected);
  if (state.tools.is_full() && !state.tools.offset_of(*tool) && !state.tools.diameter_of(*tool))
    statement.fail(p, "more than 1000 tools", "LinuxCNC's limit");
  if (z) state.tools.set_offset(*tool, length_of(statement, *z, state));
  if (r) state.tools.set_diameter(*tool, 2 * length_of(statement, *r, state));
}

/// LinuxCNC keeps one offset for G92 and G52, Fanuc one for each.
void check_one_shift(const Statement& statement, MachineState& state) {
  const int code = *statement.g(GGroup::non_modal);
  const bool is_set = state.systems.g92_mm() != Vec3{};
  if (statement.rules().fanuc_offsets && is_set && state.shifted_by != code)
    statement.fail(*statement.g_word(GGroup::non_modal),
                   "G52 and G92 one upon the other are not carried out", "one of them");
  state.shifted_by = code;
}

/// P of G54.1 and of G10 L20 on Fanuc: 1 on.
std::size_t extended_system_of(const Statement& statement, const Word& code) {
  const int most = statement.rules().extended_systems;
  const std::string expected = "P1 to P" + std::to_string(most);
  const Word* const p = statement.word('P');
  if (!p) statement.fail(code, in_quotes(code.text) + " without its P", expected);
  const auto number = whole(p->value, kWholeCount);
  if (!number || *number < 1 || *number > most)
    statement.fail(*p, in_quotes(p->text) + " names no coordinate system", expected);
  return kWorkOffsets + static_cast<std::size_t>(*number - 1);
}

/// G10 L10 to L13 of Fanuc and Haas: length and its wear by H's number, radius or diameter and its
/// wear by D's (B-63684EN, 14.1.7; Haas, "G10 Set Offsets").
void set_fanuc_tool_data(const Statement& statement, MachineState& state, int kind,
                         Assumptions& assumed) {
  const char* const expected = "P with the offset's number, and R";
  const Word &p = required(statement, 'P', expected), &r = required(statement, 'R', expected);
  refuse_words(statement, {'I', 'J', 'Q', 'X', 'Y', 'Z'}, "G10 L10 to L13");
  const auto number = whole(p.value, kWholeCount);
  if (!number || *number < 1) statement.fail(p, in_quotes(p.text) + " names no offset", expected);
  ToolTable& tools = state.tools;
  if (state.modal.incremental)
    statement.fail(r, "G10 in G91 adds to an offset of the control's memory", "G90");
  if (tools.is_full() && !tools.offset_of(*number) && !tools.diameter_of(*number))
    statement.fail(p, "more than 1000 tools", "fewer");
  const double value_mm = length_of(statement, r, state);
  if (kind == 10) return tools.set_offset(*number, value_mm);
  if (kind == 11) return tools.set_length_wear(*number, value_mm);
  forbid_compensation(statement, p, state);
  const bool by_diameter = statement.rules().control == Control::haas;
  assumed.add(statement.line(), by_diameter
                                    ? "G10 L12 and L13 state diameters (Haas's setting 40)"
                                    : "G10 L12 and L13 state radii (Fanuc's parameter 5004#2)");
  const double diameter_mm = by_diameter ? value_mm : 2 * value_mm;
  if (kind == 12) return tools.set_diameter(*number, diameter_mm);
  tools.set_diameter_wear(*number, diameter_mm);
}

void set_fanuc_data(const Statement& statement, MachineState& state, const Word& l,
                    Assumptions& assumed) {
  const int kind = whole(l.value).value_or(-1);
  if (kind == 2) return set_origin(statement, state, system_of(statement, state), assumed);
  if (kind == 20)
    return set_origin(statement, state,
                      extended_system_of(statement, *statement.g_word(GGroup::non_modal)), assumed);
  if (kind >= 10 && kind <= 13) return set_fanuc_tool_data(statement, state, kind, assumed);
  statement.fail(l, in_quotes(l.text) + " beside G10 is not carried out",
                 "L2 or L20 for a coordinate system, L10 to L13 for a tool offset");
}

}  // namespace

void select_system(const Statement& statement, MachineState& state, Assumptions& assumed) {
  forbid_compensation(statement, *statement.g_word(GGroup::coordinate_system), state);
  check_frame_is_free(statement, *statement.g_word(GGroup::coordinate_system), state);
  const Word& word = *statement.g_word(GGroup::coordinate_system);
  const int code = *statement.g(GGroup::coordinate_system);
  constexpr int kFirstByCode = 1100;  // Haas's G110: the first beyond G59
  const auto index = code == 541 ? extended_system_of(statement, word)
                     : code >= kFirstByCode
                         ? kWorkOffsets + static_cast<std::size_t>((code - kFirstByCode) / 10)
                         : static_cast<std::size_t>(code <= 590 ? (code - 540) / 10 : code - 585);
  const CoordinateSystem& system = state.systems.system(index);
  if (system.is_fresh && index != 0 && !system.is_set_by_program())
    assumed.add(statement.line(), work_offset_name(index) + " lies at the machine's zero");
  if (statement.rules().offsets_move_axes && index != state.systems.active())
    state.modal.is_due = {true, true, true};
  state.keeping_tip([&] { state.systems.select(index); });
}

void set_data(const Statement& statement, MachineState& state, Program& program,
              Assumptions& assumed) {
  const char* const expected = "L2 or L20 for a coordinate system, L1 for a tool";
  const Word& l = required(statement, 'L', expected);
  check_frame_is_free(statement, *statement.g_word(GGroup::non_modal), state);
  if (statement.rules().fanuc_offsets) return set_fanuc_data(statement, state, l, assumed);
  const int kind = whole(l.value).value_or(-1);
  if (kind == 2) return set_origin(statement, state, system_of(statement, state), assumed);
  if (kind == 20) return touch_system(statement, state, program, assumed);
  if (kind == 1) return set_tool_data(statement, state);
  if (kind == 10 || kind == 11)
    statement.fail(l,
                   "G10 " + std::string(l.text) +
                       " is not carried out: it measures a tool against a place that only the"
                       " machine knows",
                   "G10 L1, or the tool's length in the machine's tool table");
  if (kind == 0)
    statement.fail(l, "G10 L0 is not carried out: it reads a file of the machine", expected);
  statement.fail(l, in_quotes(l.text) + " beside G10", expected);
}

void set_axis_offsets(const Statement& statement, MachineState& state, Program& program,
                      Assumptions& assumed) {
  forbid_compensation(statement, *statement.g_word(GGroup::non_modal), state);
  check_frame_is_free(statement, *statement.g_word(GGroup::non_modal), state);
  const bool shifts = statement.g(GGroup::non_modal) == 520;
  if (!statement.has_axes() && statement.has_rotary()) return;
  check_one_shift(statement, state);
  if (!statement.has_axes())
    statement.fail(*statement.g_word(GGroup::non_modal),
                   in_quotes(statement.g_word(GGroup::non_modal)->text) + " without an axis word",
                   "X, Y or Z");
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    if (!word) continue;
    check_place(statement, *word, state, axis);
    const double value_mm = length_of(statement, *word, state);
    const double before_mm = state.systems.g92_mm()[axis];
    if (!shifts && states_place(state, axis)) {
      take_place(statement, state, axis, value_mm, program, assumed);
      state.systems.set_g92(axis, before_mm);
    } else if (shifts) {
      state.systems.set_g92(axis, value_mm);
      state.position_mm[axis] += before_mm - value_mm;
    } else {
      if (!state.systems.system().usable[axis])
        statement.fail(*word, "G92 under " + state.systems.name() + ", which nothing states",
                       kOffsetRemedy);
      state.systems.set_g92(axis, state.position_mm[axis] + before_mm - value_mm);
      state.position_mm[axis] = value_mm;
    }
  }
  state.refresh();
}

void apply_axis_offsets(const Statement& statement, MachineState& state) {
  forbid_compensation(statement, *statement.g_word(GGroup::axis_offset), state);
  check_frame_is_free(statement, *statement.g_word(GGroup::axis_offset), state);
  const int code = *statement.g(GGroup::axis_offset);
  if (code == 923 && !state.systems.g92_was_set() && !state.fresh)
    statement.fail(*statement.g_word(GGroup::axis_offset),
                   "G92.3 restores offsets that the program has not set", "G92 or G52 before it");
  state.keeping_tip([&] {
    if (code == 923) {
      state.systems.restore_g92();
    } else {
      state.systems.cancel_g92(code == 921);
    }
  });
}

}  // namespace limitgauge::model::gcode
