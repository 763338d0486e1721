#include "model/gcode/read/radius_codes.h"

#include "model/base/tolerance.h"
#include "model/gcode/read/tool_codes.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

/// Fanuc's and Haas's D stays until the next; D0 is no offset.
double modal_diameter(const Statement& statement, const Word& code, const MachineState& state) {
  const auto number = state.modal.diameter_number;
  const Word* const d = statement.word('D');
  if (!number)
    statement.fail(code, in_quotes(code.text) + " without the number of its offset", "D");
  const auto diameter_mm = *number == 0 ? 0.0 : state.tools.diameter_of(*number);
  if (!diameter_mm)
    statement.fail(
        d ? *d : code,
        "cutter compensation by offset D" + std::to_string(*number) + ", which nothing states",
        "G10 L12, or the tool table ([machine] tools in the job, or --tool-table)");
  return *diameter_mm;
}

double diameter_of(const Statement& statement, const Word& code, const MachineState& state,
                   bool dynamic) {
  const Word* const d = statement.word('D');
  if (statement.rules().modal_offset_words) return modal_diameter(statement, code, state);
  if (dynamic && !d) statement.fail(code, in_quotes(code.text) + " without its diameter", "D");
  if (dynamic) return length_of(statement, *d, state);
  // Siemens's D names an edge of the tool in the spindle, and no tool.
  const bool by_edge = statement.rules().length_by_d;
  if (state.modal.without_edge)
    statement.fail(code, in_quotes(code.text) + " under D0, which takes out the radius too",
                   "D1 before it");
  const auto number = d && !by_edge ? whole(d->value, kWholeCount) : 0;
  if (!number || *number < 0)
    statement.fail(*d, in_quotes(d->text) + " names no tool", "an integer from 0");
  const auto tool = *number == 0 ? state.tools.loaded() : number;
  const auto diameter_mm = state.tools.diameter_of(tool.value_or(0));
  if (!diameter_mm)
    statement.fail(d ? *d : code,
                   "cutter compensation by the diameter of " +
                       (tool ? "tool " + std::to_string(*tool) : "the tool in the spindle") +
                       ", which nothing states",
                   "the tool table ([machine] tools in the job, or --tool-table), or G41.1 D");
  return *diameter_mm;
}

/// The tool whose diameter cutter compensation takes; none of a diameter that the block states.
std::optional<int> diameter_number(const Statement& statement, const MachineState& state,
                                   bool dynamic) {
  const ControlRules& rules = statement.rules();
  if (rules.modal_offset_words) return state.modal.diameter_number;
  const Word* const d = statement.word('D');
  if (dynamic || !d || rules.length_by_d) return std::nullopt;
  return whole(d->value, kWholeCount);
}

/// A habit of some shops and a fault in others: carried out as it stands, and told.
void tell_other_diameter(const Statement& statement, const MachineState& state, bool dynamic,
                         Assumptions& assumed) {
  const auto number = diameter_number(statement, state, dynamic);
  const auto loaded = state.tools.loaded();
  if (number && *number != 0 && loaded && *loaded != 0 && number != loaded)
    assumed.add(statement.line(), "the diameter of tool " + std::to_string(*number) +
                                      " is used for cutter compensation while " +
                                      loaded_name(state) + " is in the spindle");
}

void begin(const Statement& statement, const Word& code, int tenths, MachineState& state,
           CutterCompensation& compensation, Assumptions& assumed) {
  forbid_compensation(statement, code, state);
  if (state.modal.plane == ArcPlane::yz)
    statement.fail(code, "cutter compensation in G19", "G17 or G18");
  if (state.is_adrift())
    statement.fail(code, "cutter compensation from a place that nothing states",
                   "a motion of each axis to a coordinate first");
  const double diameter_mm = diameter_of(statement, code, state, tenths % 10 == 1);
  tell_other_diameter(statement, state, tenths % 10 == 1, assumed);
  const bool left = tenths / 10 == 41;
  const ControlRules& rules = statement.rules();
  if (!rules.compensation_as_set.empty())
    assumed.add(statement.line(),
                "cutter compensation with " + std::string(rules.compensation_as_set));
  compensation.use_inches(state.modal.unit_mm != 1);
  compensation.begin(left ? CompensationSide::left : CompensationSide::right, diameter_mm / 2,
                     state.modal.plane, state.position_mm, rules.compensation);
  // LinuxCNC turns a negative radius over to the other side.
  state.modal.compensation = left == (diameter_mm >= 0) ? 410 : 420;
}

}  // namespace

void set_radius_offset(const Statement& statement, MachineState& state,
                       CutterCompensation& compensation, Assumptions& assumed) {
  const auto tenths = statement.g(GGroup::radius_offset);
  if (!tenths) return;
  const Word& code = *statement.g_word(GGroup::radius_offset);
  const ControlRules& rules = statement.rules();
  if (*tenths != 400) return begin(statement, code, *tenths, state, compensation, assumed);
  if (compensation.active() && !names_place(statement, state.modal.plane) &&
      rules.compensation != CompensationStyle::linuxcnc)
    assumed.add(statement.line(), "G40 takes effect with the next move in its plane");
  compensation.end();
  state.modal.compensation = 400;
}

}  // namespace limitgauge::model::gcode
