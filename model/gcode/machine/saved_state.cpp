#include "model/gcode/machine/saved_state.h"

#include "model/gcode/read/tool_codes.h"

namespace limitgauge::model::gcode {

SavedStates::Saved* SavedStates::current() {
  const bool here = !saved_.empty() && saved_.back().depth == parameters_.depth() &&
                    saved_.back().call == parameters_.call_at(parameters_.depth());
  return here ? &saved_.back() : nullptr;
}

void SavedStates::carry_out(const Statement& statement) {
  const auto code = statement.m(MGroup::saved_state);
  if (!code) return;
  const Word& word = *statement.m_word(MGroup::saved_state);
  Saved* saved = current();
  if (*code == 71) {
    if (saved) saved_.pop_back();
    return;
  }
  if (*code == 72) {
    if (!saved) statement.fail(word, "M72 where no state is saved", "M70 or M73 before it");
    if (!restore(*saved)) fail(statement, word);
    return;
  }
  if (!saved) saved = &saved_.emplace_back();
  const std::size_t depth = parameters_.depth();
  *saved = {depth,          parameters_.call_at(depth), *code == 73, state_.modal, state_.spindle,
            state_.coolant, state_.systems.active()};
}

bool SavedStates::leave_calls() {
  while (!saved_.empty()) {
    const Saved& innermost = saved_.back();
    if (parameters_.call_at(innermost.depth) == innermost.call) return true;
    if (innermost.returns && !restore(innermost)) return false;
    saved_.pop_back();
  }
  return true;
}

bool SavedStates::restore(const Saved& saved) {
  const int compensation = state_.modal.compensation;
  if (saved.modal.compensation != compensation && saved.modal.compensation != 400) return false;
  if (saved.modal.compensation != compensation) compensation_.end();
  const auto motion = state_.modal.motion;
  const int length_offset = state_.modal.length_offset;
  const bool plane_kept = saved.modal.plane == state_.modal.plane;
  const bool system_kept = saved.system == state_.systems.active();
  if (compensation_.active() && !(plane_kept && system_kept)) return false;
  state_.modal = saved.modal;
  state_.modal.motion = motion;
  state_.modal.length_offset = length_offset;
  state_.spindle = saved.spindle;
  state_.coolant = saved.coolant;
  if (!restore_length_offset(state_, saved.modal.length_offset)) return false;
  state_.keeping_tip([&] { state_.systems.select(saved.system); });
  return true;
}

void SavedStates::fail(const Statement& statement, const Word& word) {
  statement.fail(word,
                 "the saved modal state cannot be brought back: cutter compensation was on, or a"
                 " length offset of G43.1 or G43.2",
                 "G40 and G43 or G49 where the state is saved");
}

}  // namespace limitgauge::model::gcode
