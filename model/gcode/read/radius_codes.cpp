#include "model/gcode/read/radius_codes.h"

#include "model/base/message_text.h"

namespace limitgauge::model::gcode {
namespace {

double diameter_of(const Statement& statement, const Word& code, const MachineState& state,
                   bool dynamic) {
  const Word* const d = statement.word('D');
  if (dynamic && !d) statement.fail(code, in_quotes(code.text) + " without its diameter", "D");
  if (dynamic) return length_of(statement, *d, state);
  const auto number = d ? whole(d->value, 0.0001) : 0;
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

void begin(const Statement& statement, const Word& code, int tenths, MachineState& state,
           CutterCompensation& compensation) {
  forbid_compensation(statement, code, state);
  if (state.modal.plane == ArcPlane::yz)
    statement.fail(code, "cutter compensation in G19", "G17 or G18");
  if (state.is_adrift())
    statement.fail(code, "cutter compensation from a place that nothing states",
                   "a motion of each axis to a coordinate first");
  const double diameter_mm = diameter_of(statement, code, state, tenths % 10 == 1);
  const bool left = tenths / 10 == 41;
  compensation.use_inches(state.modal.unit_mm != 1);
  compensation.begin(left ? CompensationSide::left : CompensationSide::right, diameter_mm / 2,
                     state.modal.plane, state.position_mm);
  // LinuxCNC turns a negative radius over to the other side.
  state.modal.compensation = left == (diameter_mm >= 0) ? 410 : 420;
}

}  // namespace

void set_radius_offset(const Statement& statement, MachineState& state,
                       CutterCompensation& compensation) {
  const auto tenths = statement.g(GGroup::radius_offset);
  if (!tenths) return;
  const Word& code = *statement.g_word(GGroup::radius_offset);
  if (*tenths != 400) return begin(statement, code, *tenths, state, compensation);
  compensation.end();
  state.modal.compensation = 400;
}

}  // namespace limitgauge::model::gcode
