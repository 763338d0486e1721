#include "model/gcode/read/tool_codes.h"

#include <limits>

#include "model/base/tolerance.h"
#include "model/gcode/cycles/canned_cycle_parameters.h"
#include "model/gcode/read/orientation_codes.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {

std::string loaded_name(const MachineState& state) {
  const auto loaded = state.tools.loaded();
  return loaded ? "tool " + std::to_string(*loaded) : "the tool in the spindle";
}

namespace {

constexpr std::size_t kMostChanges = 1'000'000;
constexpr const char* kLengths = "the tools' lengths ([machine] tools in the job, or --tool-table)";

int tool_number(const Statement& statement, const Word& word, const std::string& name) {
  const auto number = whole(word.value, 0);
  if (!number || *number < 0)
    statement.fail(word, name + " " + in_quotes(word.text), "an integer from 0");
  return *number;
}

void use_stated(const Statement& statement, MachineState& state, double offset_mm,
                Assumptions& assumed) {
  if (state.tools.is_full() && !state.tools.true_length())
    statement.fail(statement.blamed(), "more than 1000 tools", "LinuxCNC's limit");
  bool taken = false;
  const auto reach_mm = state.tools.reach();
  state.keeping_tip([&] { taken = state.tools.use_offset(offset_mm); });
  if (!taken) return;
  assumed.add(statement.line(), loaded_name(state) + " is taken to be as long as its offset, " +
                                    shortest(offset_mm) + " mm");
  // It was followed as if it were as long as the one before.
  if (reach_mm) state.lower_tip(statement.line(), offset_mm - *reach_mm);
}

void use_own(const Statement& statement, MachineState& state, Assumptions& assumed) {
  state.keeping_tip([&] { state.tools.use_own_length(); });
  assumed.add(statement.line(), "the length offset is taken to be the length of " +
                                    loaded_name(state) + ", which nothing states");
}

/// G43 of tool `number`'s entry.
void use_entry(const Statement& statement, const Word& blamed, int number, MachineState& state,
               Assumptions& assumed) {
  const std::optional<double> entry_mm = number == 0 ? 0.0 : state.tools.offset_of(number);
  const bool own = state.tools.loaded() == number;
  if (!own && (!entry_mm || !state.tools.true_length()))
    statement.fail(blamed,
                   "the length offset of tool " + std::to_string(number) + " while " +
                       loaded_name(state) + " is in the spindle, their lengths not stated",
                   "H" + (state.tools.loaded() ? std::to_string(*state.tools.loaded()) : "") +
                       ", or " + kLengths);
  // A habit of some shops and a fault in others: carried out as it stands, and told.
  if (!own && number != 0)
    assumed.add(statement.line(), "the length offset of tool " + std::to_string(number) +
                                      " is used while " + loaded_name(state) +
                                      " is in the spindle");
  if (entry_mm) return use_stated(statement, state, *entry_mm, assumed);
  use_own(statement, state, assumed);
}

/// By codes or words that change the tool's length and name no Z.
void note_still_length(const Statement& statement, bool was_in_use, Assumptions& assumed) {
  if (statement.rules().control != Control::fanuc || statement.word('Z')) return;
  const bool ends = statement.g(GGroup::length_offset) == 490;
  if (ends && !was_in_use) return;
  assumed.add(statement.line(), std::string(ends ? "G49" : "G43 or H") +
                                    " is taken to move nothing by itself; a control may be set to "
                                    "move Z by the tool's length there (parameter 5006)");
}

/// Fanuc's and Haas's H stays until the next; H0 is no offset.
void use_modal_offset(const Statement& statement, MachineState& state, Assumptions& assumed) {
  const Word* const h = statement.word('H');
  const Word* const code = statement.g_word(GGroup::length_offset);
  const auto number = state.modal.length_number;
  if (!number) statement.fail(*code, "G43 without the number of its offset", "H");
  if (*number == 0) return state.keeping_tip([&] { state.tools.clear_offset(); });
  if (!state.tools.loaded()) {
    assumed.add(statement.line(),
                "the tool in the spindle is taken to be tool " + std::to_string(*number));
    state.keeping_tip([&] { state.tools.load(*number); });
  }
  use_entry(statement, h ? *h : *code, *number, state, assumed);
}

/// Siemens's D: the length of the tool in the spindle, of one cutting edge; D0 is none.
void use_edge(const Statement& statement, const Word& d, MachineState& state,
              Assumptions& assumed) {
  const int edge = tool_number(statement, d, "cutting edge");
  forbid_compensation(statement, d, state);
  state.modal.edge_is_taken = false;
  state.modal.without_edge = edge == 0;
  state.modal.is_due[2] = statement.rules().length_moves_z;
  if (edge == 0) return state.keeping_tip([&] { state.tools.clear_offset(); });
  const auto loaded = state.tools.loaded();
  const auto entry_mm = loaded ? state.tools.offset_of(*loaded) : std::nullopt;
  if (edge != 1)
    statement.fail(d, in_quotes(d.text) + " is another edge of the tool, which nothing states",
                   "D1, or D0");
  if (entry_mm) return use_stated(statement, state, *entry_mm, assumed);
  use_own(statement, state, assumed);
}

void use_offset(const Statement& statement, MachineState& state, Assumptions& assumed) {
  if (statement.rules().modal_offset_words) return use_modal_offset(statement, state, assumed);
  const Word* const h = statement.word('H');
  const int number = h ? tool_number(statement, *h, "length offset") : 0;
  // LinuxCNC's H0 is the tool in the spindle.
  if (number != 0) {
    if (!state.tools.loaded()) {
      assumed.add(statement.line(),
                  "the tool in the spindle is taken to be tool " + std::to_string(number));
      state.keeping_tip([&] { state.tools.load(number); });
    }
    return use_entry(statement, *h, number, state, assumed);
  }
  if (!state.tools.loaded()) return use_own(statement, state, assumed);
  use_entry(statement, *statement.g_word(GGroup::length_offset), *state.tools.loaded(), state,
            assumed);
}

/// G43.1: the offset stands in the block.
void use_dynamic(const Statement& statement, MachineState& state, Assumptions& assumed) {
  const Word& code = *statement.g_word(GGroup::length_offset);
  for (const char axis : {'X', 'Y'}) {
    if (const Word* word = statement.word(axis); word && word->value != 0)
      statement.fail(*word, "a tool offset along " + std::string(1, axis) + " is not carried out",
                     "0, or Z only");
  }
  if (!statement.has_axes()) statement.fail(code, "G43.1 without an offset", "Z");
  if (const Word* z = statement.word('Z'))
    use_stated(statement, state, length_of(statement, *z, state), assumed);
}

/// G43.2: LinuxCNC 2.9 adds the entry that H names.
void add_entry(const Statement& statement, MachineState& state) {
  const Word* const h = statement.word('H');
  if (!h)
    statement.fail(*statement.g_word(GGroup::length_offset), "G43.2 without the entry to add", "H");
  const int number = tool_number(statement, *h, "length offset");
  const auto entry_mm = number == 0 ? 0.0 : state.tools.offset_of(number);
  if (!entry_mm)
    statement.fail(*h, "the length offset of tool " + std::to_string(number) + " is not stated",
                   kLengths);
  state.keeping_tip([&] { state.tools.add_offset(*entry_mm); });
}

}  // namespace

void select_tool(const Statement& statement, MachineState& state) {
  const Word* t = statement.word('T');
  if (!t) return;
  state.selected_tool = tool_number(statement, *t, "tool number");
  state.selected_line = statement.line();
}

namespace {

/// Siemens's D1, which is in effect behind a change as the controls come (MD 20270), unless the
/// program says another.
void take_first_edge(MachineState& state, int tool) {
  const auto entry_mm = state.tools.offset_of(tool);
  if (!entry_mm) return;
  state.keeping_tip([&] { state.tools.use_offset(*entry_mm); });
  state.modal.edge_is_taken = state.modal.is_due[2] = true;
}

/// The spindle stands still: the tip of a longer tool comes to stand further down along it. One of
/// a length that nothing states is taken to have been set to where the one before stood.
void load_where_it_stands(const Statement& statement, int tool, MachineState& state,
                          Assumptions& assumed) {
  const auto before_mm = state.tools.reach();
  state.keeping_tip([&] { state.tools.load(tool); });
  const auto after_mm = state.tools.reach();
  if (!after_mm || after_mm == before_mm) return;
  state.lower_tip(statement.line(), *after_mm - before_mm.value_or(0));
  if (!before_mm && state.moved_tip)
    assumed.add(statement.line(),
                "the tool before T" + std::to_string(tool) +
                    ", whose length nothing states, is taken to have had none: the tip of T" +
                    std::to_string(tool) + " comes to stand as far below as that is long");
}

}  // namespace

void change_tool(const Statement& statement, MachineState& state, Program& program,
                 Assumptions& assumed) {
  const auto code = statement.m(MGroup::tool_change);
  if (!code) return;
  const Word& word = *statement.m_word(MGroup::tool_change);
  forbid_compensation(statement, word, state);
  std::optional<int> tool = state.selected_tool;
  if (*code == 61) {
    const Word* const q = statement.word('Q');
    if (!q) statement.fail(word, "M61 without a tool", "Q with its number");
    tool = tool_number(statement, *q, "tool number");
  } else if (!tool) {
    statement.fail(word, "a tool change without a tool", "T before M6");
  }
  state.has_changed_tool = true;
  if (program.tool_changes.size() >= kMostChanges)
    statement.fail(word, "more than a million tool changes", "fewer");
  if (state.tools.loaded() != tool)
    program.tool_changes.push_back({statement.line(), program.motions.size(), *tool});
  load_where_it_stands(statement, *tool, state, assumed);
  state.modal.without_edge = false;
  if (statement.rules().length_by_d) take_first_edge(state, *tool);
}

void take_offset_numbers(const Statement& statement, MachineState& state) {
  if (!statement.rules().modal_offset_words) return;
  if (const Word* h = statement.word('H'))
    state.modal.length_number = tool_number(statement, *h, "length offset");
  const Word* const d = statement.word('D');
  if (!d) return;
  const int number = tool_number(statement, *d, "cutter offset");
  if (number != state.modal.diameter_number && !statement.g(GGroup::radius_offset))
    forbid_compensation(statement, *d, state);
  state.modal.diameter_number = number;
}

void set_length_offset(const Statement& statement, MachineState& state, Assumptions& assumed) {
  const auto code = statement.g(GGroup::length_offset);
  const Word *const h = statement.word('H'), *const d = statement.word('D');
  const ControlRules& rules = statement.rules();
  if (d && rules.length_by_d) use_edge(statement, *d, state, assumed);
  const bool again = !code && h && rules.modal_offset_words && state.modal.length_offset == 430;
  if (code || again) {
    state.modal.length_cancelled_by.reset();
    state.modal.is_due[2] = rules.length_moves_z;
  }
  if (!code && !again) return;
  forbid_compensation(statement, again ? *h : *statement.g_word(GGroup::length_offset), state);
  note_still_length(statement, state.tools.has_offset_in_use(), assumed);
  if (again) return use_modal_offset(statement, state, assumed);
  const bool centres = *code == 434 || *code == 435;
  state.modal.length_offset = centres ? 430 : *code;
  if (*code == 490 || centres)
    leave_tool_centre(statement, state);
  else if (rules.modal_offset_words)
    forbid_in_tool_centre(statement, state);
  if (centres) {
    use_offset(statement, state, assumed);
    return enter_tool_centre(statement, state, assumed);
  }
  if (*code == 490) return state.keeping_tip([&] { state.tools.clear_offset(); });
  if (*code == 430) return use_offset(statement, state, assumed);
  if (*code == 431) return use_dynamic(statement, state, assumed);
  add_entry(statement, state);
}

bool restore_length_offset(MachineState& state, int code) {
  const bool on = code != 490;
  if (on == (state.modal.length_offset != 490)) return true;
  if (on && code != 430) return false;
  state.modal.length_offset = code;
  const auto loaded = state.tools.loaded();
  const auto entry_mm = loaded ? state.tools.offset_of(*loaded) : std::nullopt;
  state.keeping_tip([&] {
    if (!on) {
      state.tools.clear_offset();
    } else if (entry_mm) {
      state.tools.use_offset(*entry_mm);
    } else {
      state.tools.use_own_length();
    }
  });
  return true;
}

void cancel_length(const Statement& statement, MachineState& state) {
  const LengthCancel cancel = statement.rules().length_cancel;
  const auto code = statement.g(GGroup::non_modal);
  const bool returns = code == 280 || code == 300, in_machine = code == 530;
  const bool moves_z =
      statement.word('Z') || (returns && !statement.has_axes() && !statement.has_rotary());
  const bool cancels =
      cancel == LengthCancel::where_z_moves ? (returns || in_machine) && moves_z : returns;
  if (cancel == LengthCancel::never || !cancels || state.orientation.tool_centred) return;
  if (!state.tools.has_offset_in_use()) return;
  state.keeping_tip([&] { state.tools.clear_offset(); });
  state.modal.length_cancelled_by = code;
  state.modal.cancelled_length_is_told = false;
}

namespace {

std::string cancelled_text(const MachineState& state) {
  return "out of effect since G" + std::to_string(*state.modal.length_cancelled_by / 10);
}

}  // namespace

void note_cancelled_length(const Statement& statement, MachineState& state, Assumptions& assumed) {
  const bool told = !state.modal.length_cancelled_by || state.modal.cancelled_length_is_told;
  if (told || statement.g(GGroup::non_modal) == 530) return;
  if (!statement.word('Z') && !is_canned_cycle(state.modal.motion.value_or(0))) return;
  assumed.add(statement.line(), "the tool's length is taken to be " + cancelled_text(state) +
                                    ": neither G43 nor H says it again");
  state.modal.cancelled_length_is_told = true;
}

void check_tip(const Statement& statement, const MachineState& state) {
  if (!state.tools.is_uncertain()) return;
  if (state.modal.length_cancelled_by)
    statement.fail(statement.blamed(),
                   "a feed motion while the length of " + loaded_name(state) + " is " +
                       cancelled_text(state) + ", and nothing states it",
                   std::string("G43 or H before it, or ") + kLengths);
  statement.fail(statement.blamed(),
                 "a feed motion under a length offset that is not that of " + loaded_name(state) +
                     ", whose length nothing states",
                 std::string("G43 for this tool, or ") + kLengths);
}

}  // namespace limitgauge::model::gcode
