// The interpreter's part for lines of axis words alone, which most of a long program are: they need
// nothing looked up while no mode says more of a motion than where it goes.
#include <cmath>

#include "model/gcode/read/interpreter.h"
#include "model/gcode/read/motion_codes.h"

namespace limitgauge::model::gcode {

/// A block that may go by move_plainly.
bool Interpreter::is_plain(const Statement& statement) const {
  return (statement.letters() & ~kAxisLetters) == 0 && statement.has_axes() &&
         statement.block().comments.empty() && !statement.block().block_delete &&
         !statement.any_set_aside() && statement.block().set_aside.empty();
}

bool Interpreter::may_be_plain() const {
  return (state_.modal.motion == 0 || state_.modal.motion == 10) && !state_.modal.motion_is_taken &&
         !state_.modal.edge_is_taken &&
         (!state_.modal.length_cancelled_by || state_.modal.cancelled_length_is_told) &&
         state_.modal.is_due == std::array<bool, 3>{} && state_.modal.units_are_stated &&
         state_.modal.distance_is_stated && state_.modal.feed_mode == FeedMode::per_minute &&
         compensation_.idle() && saved_.empty() && !state_.is_adrift() &&
         !state_.tools.is_uncertain() && state_.systems.system().is_usable();
}

Motion Interpreter::plain_motion(const Vec3& to_mm) {
  Motion motion;
  const bool rapid = state_.modal.motion == 0;
  motion.kind = rapid ? MotionKind::rapid : MotionKind::feed;
  motion.plane = state_.modal.plane;
  if (!rapid) motion.feed_mm_min = static_cast<float>(state_.modal.feed_mm);
  motion.to = state_.position_mm = to_mm;
  return motion;
}

void Interpreter::move_plainly(const Statement& statement) {
  emit(statement, plain_motion(end_of(statement, state_)));
}

/// The motion code that is in force already changes nothing, save that a cycle comes back to it.
bool Interpreter::keeps_modes(const PlainLine& line) const {
  const std::ptrdiff_t least_decimals = state_.modal.unit_mm == 1 ? 3 : 4;
  const bool doubtful = (doubts_lengths_ && line.has_whole_number) ||
                        (doubts_decimals_ && line.most_decimals > least_decimals);
  const bool same =
      !line.motion || (line.motion == state_.modal.motion &&
                       state_.modal.beside_cycles.value_or(*line.motion) == *line.motion);
  return plain_ && same && !doubtful && motions_so_far() < most_motions_;
}

/// Where the line leads; nothing beyond any machine.
std::optional<Vec3> Interpreter::plain_end(const PlainLine& line) const {
  Vec3 to_mm = state_.position_mm;
  for (int axis = 0; axis < 3; ++axis) {
    if (!line.states(static_cast<std::size_t>(axis))) continue;
    const double given_mm = line.axes[static_cast<std::size_t>(axis)] * state_.modal.unit_mm;
    to_mm[axis] = given_mm + (state_.modal.incremental ? to_mm[axis] : 0);
    if (!(std::abs(to_mm[axis]) <= kLargestCoordinateMm)) return std::nullopt;
  }
  return to_mm;
}

bool Interpreter::move_plainly(const PlainLine& line) {
  if (!keeps_modes(line)) return false;
  const std::optional<Vec3> to_mm = plain_end(line);
  if (!to_mm) return false;
  for (std::size_t axis = 0; axis < 3 && !state_.modal.incremental; ++axis)
    if (line.states(axis)) state_.known[axis] = true;
  Motion motion = plain_motion(*to_mm);
  send(line.line, motion);
  return true;
}

}  // namespace limitgauge::model::gcode
