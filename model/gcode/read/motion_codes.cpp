#include "model/gcode/read/motion_codes.h"

#include <cmath>
#include <numbers>

#include "model/gcode/cycles/polar_place.h"
#include "model/gcode/machine/feed.h"
#include "model/gcode/machine/machine_motion.h"
#include "model/gcode/read/arc.h"
#include "model/gcode/read/tool_codes.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

/// More turns in one block are a typing error, and each becomes at least four chords.
constexpr double kMostTurns = 10000;

[[noreturn]] void fail_adrift(const Statement& statement, const Word& word, int axis) {
  statement.fail(word,
                 in_quotes(word.text) + " starts where nothing states the place of " + kAxes[axis] +
                     ": it was sent to a reference point or the machine's zero",
                 "the axis in G90 first, or the machine's setup");
}

/// X and Y may travel at a place that nothing states only while Z is above everything.
void check_descent(const Statement& statement, const MachineState& state) {
  const Word* const z = statement.word('Z');
  if (z && (state.adrift[0] || state.adrift[1]))
    statement.fail(*z, "Z comes down while nothing states where X and Y are",
                   "X and Y in a block before it, or the machine's setup");
}

double axis_end(const Statement& statement, const Word& word, MachineState& state, int axis) {
  const bool incremental = state.modal.incremental;
  if (incremental && state.adrift[axis]) fail_adrift(statement, word, axis);
  const double end_mm =
      word.value * state.modal.unit_mm + (incremental ? state.position_mm[axis] : 0);
  if (!(std::abs(end_mm) <= kLargestCoordinateMm))
    statement.fail(word, "a position beyond any machine", "at most 1e9 mm");
  if (!incremental) state.known[axis] = true, state.adrift[axis] = false;
  return end_mm;
}

void take_polar(const Statement& statement, MachineState& state, Vec3& end_mm) {
  const PolarPlace polar = polar_of(statement, state.modal.unit_mm, state.modal.incremental);
  const Word& word = *statement.first_of({'@', '^'});
  for (int axis = 0; axis < 2; ++axis)
    if (state.adrift[axis] && !polar.is_stated()) fail_adrift(statement, word, axis);
  const auto [x, y] = polar_end(statement, polar, {end_mm.x, end_mm.y});
  end_mm.x = x, end_mm.y = y;
  if (!polar.is_stated()) return;
  for (int axis = 0; axis < 2; ++axis) state.known[axis] = true, state.adrift[axis] = false;
}

Vec2 centre_words(const Statement& statement, const MachineState& state) {
  const auto [first, second, normal] = axes_of(state.modal.plane);
  const Word* const stray = statement.word(kCentres[normal]);
  if (stray && !(stray->value == 0 && statement.rules().idle_centre_words))
    statement.fail(*stray, in_quotes(stray->text) + " is no centre word of this plane",
                   std::string(1, kCentres[first]) + " and " + kCentres[second]);
  const bool absolute = state.modal.centre_absolute;
  Vec2 centre{};
  for (int i = 0; i < 2; ++i) {
    const int axis = i == 0 ? first : second;
    const Word* const word = statement.word(kCentres[axis]);
    if (!word && absolute)
      statement.fail(*statement.first_of({'I', 'J', 'K'}),
                     std::string("an absolute centre without ") + kCentres[axis],
                     "both words of the centre under G90.1");
    const double given_mm = word ? word->value * state.modal.unit_mm : 0;
    centre[i] = given_mm + (absolute ? 0 : state.position_mm[axis]);
    if (!(std::abs(centre[i]) <= kLargestCoordinateMm))
      statement.fail(*word, "a centre beyond any machine", "at most 1e9 mm");
  }
  return centre;
}

/// LinuxCNC's count: one for the part turn that reaches the end point, one more for each whole
/// turn.
double turns_of(const Statement& statement) {
  const Word* const p = statement.word('P');
  if (!p) return 1;
  const double count = std::round(p->value);
  if (!(std::abs(p->value - count) <= 0.001) || count < 1 || count > kMostTurns)
    statement.fail(*p, in_quotes(p->text) + " turns of an arc", "an integer from 1 to 10000");
  return count;
}

ArcCentre find_centre(const Statement& statement, const MachineState& state, Vec2 start, Vec2 end,
                      bool counter_clockwise) {
  const auto [first, second, normal] = axes_of(state.modal.plane);
  const Word* const radius = statement.word('R');
  const Word* const centre = statement.first_of({'I', 'J', 'K'});
  if (!radius && !centre)
    statement.fail(statement.blamed(), "an arc without centre or radius", "I J K or R");
  if (radius && centre) statement.fail(*radius, "R beside I, J or K", "one of the two forms");
  if (radius && !statement.word(kAxes[first]) && !statement.word(kAxes[second]) &&
      !statement.is_polar())
    statement.fail(*radius, "an arc by radius without its end point in the plane",
                   std::string(1, kAxes[first]) + " or " + kAxes[second]);
  const double unit_mm = state.modal.unit_mm;
  const double spiral_mm = unit_mm == 1 ? kSpiralToleranceMm : kSpiralToleranceInch * kInchMm;
  const ArcCentre found =
      radius ? centre_by_radius(start, end, radius->value * unit_mm, counter_clockwise)
             : centre_by_offset(start, end, centre_words(statement, state), spiral_mm);
  if (!found.wrong.empty()) statement.fail(centre ? *centre : *radius, found.wrong, found.expected);
  return found;
}

/// Length of an arc from `start`, for G93: a helix along its normal axis.
double arc_length(const Motion& arc, const Vec3& start) {
  const auto [first, second, normal] = axes_of(arc.plane);
  const double x1 = start[first] - arc.centre1, y1 = start[second] - arc.centre2;
  const double x2 = arc.to[first] - arc.centre1, y2 = arc.to[second] - arc.centre2;
  const double turn = 2 * std::numbers::pi;
  double angle = std::atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2);
  if (arc.turns < 0) angle = -angle;
  if (angle <= 0) angle += turn;
  angle += (std::abs(arc.turns) - 1) * turn;
  return std::hypot(std::hypot(x1, y1) * angle, arc.to[normal] - start[normal]);
}

}  // namespace

void take_due_offsets(const Statement& statement, MachineState& state) {
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    bool& is_due = state.modal.is_due[static_cast<std::size_t>(axis)];
    if (!word || !is_due) continue;
    if (state.modal.incremental)
      statement.fail(*word,
                     in_quotes(word->text) + " in G91 behind a change of the " +
                         (statement.rules().offsets_move_axes ? "zero offset or the " : "") +
                         "tool's length, which the control adds to it",
                     std::string(1, kAxes[axis]) + " in G90 first");
    is_due = false;
  }
}

Vec3 end_of(const Statement& statement, MachineState& state) {
  check_descent(statement, state);
  take_due_offsets(statement, state);
  Vec3 end_mm = state.position_mm;
  for (int axis = 0; axis < 3; ++axis) {
    if (const Word* const word = statement.word(kAxes[axis]))
      end_mm[axis] = axis_end(statement, *word, state, axis);
  }
  if (statement.is_polar()) take_polar(statement, state, end_mm);
  return end_mm;
}

Vec3 waypoint_of(const Statement& statement, MachineState& state) {
  const auto stays = [&](int axis) {
    return state.modal.incremental && state.adrift[axis] && statement.word(kAxes[axis])->value == 0;
  };
  if (statement.word('Z') && !stays(2)) check_descent(statement, state);
  Vec3 end_mm = state.position_mm;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    if (word && !stays(axis)) end_mm[axis] = axis_end(statement, *word, state, axis);
  }
  return end_mm;
}

Motion straight_motion(const Statement& statement, MachineState& state, bool rapid,
                       Assumptions& assumed) {
  check_system(statement, state);
  if (!rapid) check_tip(statement, state);
  Motion motion;
  motion.kind = rapid ? MotionKind::rapid : MotionKind::feed;
  motion.plane = state.modal.plane;
  const bool in_machine = statement.g(GGroup::non_modal) == 530;
  motion.to = in_machine ? machine_end(statement, state, rapid, assumed) : end_of(statement, state);
  if (!rapid)
    motion.feed_mm_min =
        static_cast<float>(feed_of(statement, state, distance(state.position_mm, motion.to)));
  state.position_mm = motion.to;
  return motion;
}

Motion arc_motion(const Statement& statement, MachineState& state, bool counter_clockwise) {
  check_system(statement, state);
  check_tip(statement, state);
  Motion motion;
  motion.kind = MotionKind::arc;
  motion.plane = state.modal.plane;
  const auto [first, second, normal] = axes_of(motion.plane);
  for (const int axis : {first, second}) {
    if (state.adrift[axis]) fail_adrift(statement, statement.blamed(), axis);
  }
  if (motion.plane != ArcPlane::xy && state.frame.rotation_deg != 0)
    statement.fail(statement.blamed(),
                   "an arc in G18 or G19 under a coordinate system that is turned about Z",
                   "G17, or straight moves");
  motion.to = end_of(statement, state);
  const ArcCentre found =
      find_centre(statement, state, {state.position_mm[first], state.position_mm[second]},
                  {motion.to[first], motion.to[second]}, counter_clockwise);
  motion.centre1 = found.centre[0];
  motion.centre2 = found.centre[1];
  motion.turns = counter_clockwise ? turns_of(statement) : -turns_of(statement);
  motion.feed_mm_min =
      static_cast<float>(feed_of(statement, state, arc_length(motion, state.position_mm)));
  state.position_mm = motion.to;
  return motion;
}

double motion_length_mm(const Motion& motion, const Vec3& from_mm) {
  return motion.kind == MotionKind::arc ? arc_length(motion, from_mm)
                                        : distance(from_mm, motion.to);
}

void check_system(const Statement& statement, const MachineState& state) {
  if (state.systems.system().is_usable()) return;
  statement.fail(statement.blamed(),
                 "a motion under " + state.systems.name() + ", which nothing states",
                 std::string(kOffsetRemedy) + ", or G10");
}

}  // namespace limitgauge::model::gcode
