#include "model/gcode/machine/feed.h"

namespace limitgauge::model::gcode {
namespace {

/// What LinuxCNC takes, in units a minute, for a motion without length in inverse time.
constexpr double kWithoutLength = 0.1;

double per_revolution(const Statement& statement, const MachineState& state) {
  if (state.modal.feed_mm == 0) return 0;
  const Word& blamed = statement.blamed();
  if (state.spindle.constant_surface)
    statement.fail(blamed,
                   "a feed per revolution at constant surface speed (G96), whose revolutions"
                   " depend on the machine",
                   "G97 and S, or G94");
  if (!state.spindle.rpm || *state.spindle.rpm == 0)
    statement.fail(blamed, "a feed per revolution without a spindle speed", "S before it, or G94");
  return state.modal.feed_mm * *state.spindle.rpm;
}

double inverse_time(const Statement& statement, const MachineState& state, double length_mm) {
  const Word* const f = statement.word('F');
  if (!f || f->value <= 0)
    statement.fail(f ? *f : statement.blamed(), "a feed motion in inverse time (G93) without its F",
                   "F above 0 in each block: one by the minutes of the motion");
  return length_mm == 0 ? kWithoutLength * state.modal.unit_mm : length_mm * f->value;
}

}  // namespace

void set_feed(const Statement& statement, MachineState& state) {
  ModalState& modal = state.modal;
  if (const auto code = statement.g(GGroup::feed_mode)) {
    modal.feed_mode = *code == 930   ? FeedMode::inverse_time
                      : *code == 940 ? FeedMode::per_minute
                                     : FeedMode::per_revolution;
    // LinuxCNC forgets the feed rate whenever a feed mode is programmed.
    modal.feed_mm = 0;
  }
  const Word* const f = statement.word('F');
  if (!f) return;
  if (f->value < 0) statement.fail(*f, "a negative feed rate", "0 or more");
  if (!(f->value * modal.feed_unit_mm <= kLargestCoordinateMm))
    statement.fail(*f, "a feed rate beyond any machine", "at most 1e9 mm/min");
  if (modal.feed_mode != FeedMode::inverse_time) modal.feed_mm = f->value * modal.feed_unit_mm;
}

double feed_of(const Statement& statement, const MachineState& state, double length_mm) {
  if (state.modal.feed_mode == FeedMode::per_minute) return state.modal.feed_mm;
  const double feed_mm_min = state.modal.feed_mode == FeedMode::inverse_time
                                 ? inverse_time(statement, state, length_mm)
                                 : per_revolution(statement, state);
  if (!(feed_mm_min <= kLargestCoordinateMm))
    statement.fail(statement.blamed(), "a feed rate beyond any machine", "at most 1e9 mm/min");
  return feed_mm_min;
}

}  // namespace limitgauge::model::gcode
