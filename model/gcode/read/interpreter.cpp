#include "model/gcode/read/interpreter.h"

#include <algorithm>
#include <utility>

#include "model/gcode/machine/feed.h"
#include "model/gcode/machine/machine_motion.h"
#include "model/gcode/machine/macro_variables.h"
#include "model/gcode/read/auxiliaries.h"
#include "model/gcode/read/motion_codes.h"
#include "model/gcode/read/offset_codes.h"
#include "model/gcode/read/orientation_codes.h"
#include "model/gcode/read/radius_codes.h"
#include "model/gcode/read/tool_codes.h"
#include "model/gcode/text/system_parameters.h"
#include "model/gcode/text/word_use.h"

namespace limitgauge::model::gcode {
Interpreter::Interpreter(Program& program, const MachineSetup& machine, const Lexer& lexer,
                         Parameters& parameters, std::size_t most_motions)
    : program_(program),
      assumed_(program.assumed),
      state_(machine),
      systems_at_start_(state_.systems),
      tools_at_start_(state_.tools),
      compensation_([this](Motion motion) { put(motion); },
                    [&lexer](std::uint32_t line) { return lexer.place(line, 1); }),
      saved_(state_, compensation_, parameters),
      most_motions_(most_motions),
      doubts_lengths_(lexer.rules().whole_lengths_doubtful),
      doubts_decimals_(lexer.rules().rounds_calculated) {
  if (const auto tool = state_.tools.loaded()) program_.tool_changes.push_back({0, 0, *tool});
  set_system_parameters(parameters, lexer.rules());
}

void Interpreter::set_system_parameters(Parameters& parameters, const ControlRules& rules) {
  if (rules.macro_b)
    return parameters.set_system(
        [this, &rules](int number) { return macro_variable(state_, rules.control, number); },
        [](std::string_view) { return std::nullopt; });
  // Where a subroutine has just ended, what it saved is back before the next line is read.
  parameters.set_system(
      [this](int number) {
        saved_.leave_calls();
        return system_parameter(state_, number);
      },
      [this, &parameters](std::string_view name) {
        saved_.leave_calls();
        return system_parameter(state_, name, parameters.depth() - 1);
      });
}

bool Interpreter::execute(const Statement& statement) {
  if (!listen(statement)) return true;
  if (plain_ && is_plain(statement)) {
    move_plainly(statement);
    return true;
  }
  list_auxiliaries(statement, program_, motions_so_far());
  if (statement.block().words.empty()) return true;
  if (!saved_.leave_calls()) SavedStates::fail(statement, statement.block().words.front());
  const std::optional<int> motion = motion_of(
      statement, state_.modal.motion, state_.modal.beside_cycles, state_.orientation.by_vector);
  check_word_use(statement, motion, state_.orientation.by_vector);
  check_turn(statement, motion);
  set_spindle_mode(statement);
  set_feed(statement, state_);
  if (state_.modal.feed_mode == FeedMode::inverse_time && motion.value_or(0) == 0)
    list_unused_feed(statement, program_);
  set_speed(statement);
  select_tool(statement, state_);
  const Vec3 from_mm = state_.position_mm;
  carry_out_m(statement);
  carry_out_g(statement, motion);
  if (statement.rules().most_still_blocks) watch_still_blocks(statement, from_mm);
  plain_ = may_be_plain();
  return stop(statement);
}

void Interpreter::finish() {
  compensation_.flush();
  const bool as_begun =
      state_.systems.lie_as(systems_at_start_) && state_.tools.has_entries_of(tools_at_start_);
  if (!as_begun) program_.offsets_left = offsets_line_;
  if (const auto tool = state_.selected_tool;
      tool && *tool != 0 && !state_.has_changed_tool && tool != state_.tools.loaded())
    assumed_.add(state_.selected_line, "T" + std::to_string(*tool) +
                                           " is never loaded, since no M6 follows: the tool in the "
                                           "spindle stays");
}

void Interpreter::carry_out_m(const Statement& statement) {
  in_joints_if(statement.m_word(MGroup::tool_change) != nullptr,
               [&] { change_tool(statement, state_, program_, assumed_); });
  turn_spindle(statement);
  saved_.carry_out(statement);
  set_coolant(statement);
}

void Interpreter::carry_out_g(const Statement& statement, std::optional<int> motion) {
  check_polar_plane(statement);
  set_plane(statement);
  set_units(statement);
  take_offset_numbers(statement, state_);
  set_radius_offset(statement, state_, compensation_, assumed_);
  set_length_offset(statement, state_, assumed_);
  set_tip_control(statement);
  if (statement.g_word(GGroup::coordinate_system)) select_system(statement, state_, assumed_);
  set_late_modes(statement);
  note_taken_modes(statement);
  carry_out_non_modal(statement);
  if (statement.g_word(GGroup::axis_offset)) apply_axis_offsets(statement, state_);
  if (statement.g(GGroup::motion)) cancel_cycle(statement);
  if (motion) move(statement, *motion);
}

bool Interpreter::stop(const Statement& statement) {
  const auto code = statement.m(MGroup::stopping);
  if (!code) return true;
  compensation_.flush();
  if (*code == 0 || *code == 1) pause_spindle(statement, *code);
  return *code != 2 && *code != 30;
}

/// LinuxCNC asks for the plane that was in effect before the block.
void Interpreter::check_polar_plane(const Statement& statement) const {
  if (statement.is_polar() && state_.modal.plane != ArcPlane::xy)
    statement.fail(*statement.first_of({'@', '^'}), "polar coordinates outside G17",
                   "G17 in a block before it");
}

void Interpreter::set_plane(const Statement& statement) {
  const auto code = statement.g(GGroup::plane);
  if (!code) return;
  const auto plane = static_cast<ArcPlane>(*code / 10);
  if (plane != state_.modal.plane)
    forbid_compensation(statement, *statement.g_word(GGroup::plane), state_);
  state_.modal.plane = plane;
  if (statement.rules().length_by_d && plane != ArcPlane::xy)
    assumed_.add(statement.line(),
                 "the tool's length is taken to act along Z in every plane (SD 42940); as the "
                 "control comes, it acts along Y in G18 and along X in G19");
}

namespace {

/// Siemens's G70 and G71 leave feeds in the unit that the control has, and G700 and G710 do not
/// ("Fundamentals", "Inch or metric").
bool is_unit_of_lengths_alone(const Statement& statement) {
  const double code = statement.g_word(GGroup::units)->value;
  return statement.rules().control == Control::siemens && code < 100;
}

}  // namespace

void Interpreter::set_units(const Statement& statement) {
  const auto code = statement.g(GGroup::units);
  if (!code) return;
  const double unit_mm = *code == 200 ? kInchMm : 1;
  // A program that mixes units may mean to; one digit does the same by accident.
  if (unit_mm != state_.modal.unit_mm && !program_.motions.empty())
    assumed_.add(statement.line(), unit_mm == 1 ? "the units change to millimetres here"
                                                : "the units change to inches here");
  state_.modal.unit_mm = unit_mm;
  state_.modal.feed_unit_mm = is_unit_of_lengths_alone(statement) ? 1 : unit_mm;
  state_.modal.units_are_stated = true;
  if (unit_mm != 1 && is_unit_of_lengths_alone(statement))
    assumed_.add(
        statement.line(),
        "feeds are taken to be in millimetres, as the control is set: G70 leaves them in its unit");
  compensation_.use_inches(*code == 200);
}

void Interpreter::set_late_modes(const Statement& statement) {
  ModalState& modal = state_.modal;
  if (const auto code = statement.g(GGroup::distance)) {
    modal.incremental = *code == 910;
    modal.distance_is_stated = true;
  }
  if (const auto code = statement.g(GGroup::arc_distance)) modal.centre_absolute = *code == 901;
  if (const auto code = statement.g(GGroup::return_level)) {
    modal.return_to_r = *code == 990;
    modal.return_is_stated = true;
  }
}

/// A control keeps the modes that it was left in, or has its own: what words mean before the
/// program says so is taken.
void Interpreter::note_taken_modes(const Statement& statement) {
  ModalState& modal = state_.modal;
  if (!statement.has_axes() || statement.g(GGroup::non_modal) == 100) return;
  // Zero has no unit, and places on the machine are absolute.
  const bool has_length = std::any_of(kAxes.begin(), kAxes.end(), [&](char axis) {
    const Word* const word = statement.word(axis);
    return word && word->value != 0;
  });
  if (has_length && !std::exchange(modal.units_are_stated, true))
    assumed_.add(statement.line(),
                 "lengths are taken to be in millimetres: nothing before says which unit");
  if (statement.g(GGroup::non_modal) != 530 && !std::exchange(modal.distance_is_stated, true))
    assumed_.add(statement.line(),
                 "places are taken to be absolute (G90): nothing before says G90 or G91");
}

void Interpreter::carry_out_non_modal(const Statement& statement) {
  switch (statement.g(GGroup::non_modal).value_or(-1)) {
    case 100:
      offsets_line_ = statement.line();
      return set_data(statement, state_, program_, assumed_);
    case 280:
    case 300:
      return go_home(statement);
    case 281:
    case 301:
      return store_reference(statement, state_);
    case 520:
    case 920:
      offsets_line_ = statement.line();
      return set_axis_offsets(statement, state_, program_, assumed_);
    case 531:
      forbid_compensation(statement, *statement.g_word(GGroup::non_modal), state_);
      return turn_in_joints(statement, plane_angles(statement, state_, assumed_), true);
    case 530:
      if (!statement.has_axes() && !statement.has_rotary() && !statement.g_word(GGroup::motion))
        statement.fail(*statement.g_word(GGroup::non_modal), "G53 without a motion",
                       "G0 or G1 and axis words");
      return;
    default:
      return;
  }
}

/// By way of the point that the axis words name.
void Interpreter::go_home(const Statement& statement) {
  forbid_compensation(statement, *statement.g_word(GGroup::non_modal), state_);
  check_system(statement, state_);
  if (const Word* p = statement.word('P'); p && p->value != 2)
    statement.fail(
        *p, in_quotes(p->text) + " beside G30: a third or fourth reference point is stated nowhere",
        "P2, the second");
  in_joints([&] { move_home(statement); });
  cancel_length(statement, state_);
}

/// All axes that are named go at once, to the point and from there. Only an axis that stays: as
/// LinuxCNC, two motions of no length.
void Interpreter::move_home(const Statement& statement) {
  const bool stays = statement.has_rotary() && !statement.has_axes();
  const RotaryAngles by_deg = rotary_end(statement, state_),
                     home_deg = turn_home(statement, by_deg);
  const bool was_parked = state_.adrift[2];
  go_to(statement, stays ? state_.position_mm : waypoint_of(statement, state_), by_deg, true);
  const Vec3 end_mm = stays ? state_.position_mm : reference_end(statement, state_, assumed_);
  check_park(statement, was_parked, home_deg);
  go_to(statement, end_mm, home_deg, true);
}

void Interpreter::move(const Statement& statement, int code) {
  const bool passes = is_rapid_in_machine_frame(statement);
  if (state_.modal.motion != code && !is_canned_cycle(code)) cycles_.forget();
  // Where G53 is a rapid of its own, what stays is the motion that stands beside it, if any.
  const auto stated = statement.g(GGroup::motion);
  if (!passes)
    state_.modal.motion = code;
  else if (stated == 0 || stated == 10)
    state_.modal.motion = *stated;
  if (state_.modal.motion_is_taken && !statement.g_word(GGroup::motion))
    assumed_.add(statement.line(),
                 "the control is taken to have begun in G0: nothing before this motion says which");
  state_.modal.motion_is_taken = false;
  if (std::exchange(state_.modal.edge_is_taken, false))
    assumed_.add(statement.line(),
                 "D1 is taken to be in effect since the change of the tool: no D says another");
  note_cancelled_length(statement, state_, assumed_);
  if (statement.g(GGroup::non_modal) == 530 && code != 0 && code != 10)
    statement.fail(*statement.g_word(GGroup::non_modal), "G53 beside a motion that is not straight",
                   "G0 or G1");
  if (code == 0 || code == 10) return move_straight(statement, code);
  if (is_canned_cycle(code)) return tap(statement, code);
  list_idle_centre(statement, state_.modal.plane, program_);
  if (turns(statement)) return turn(statement, code);
  emit(statement, arc_motion(statement, state_, code == 30));
}

void Interpreter::move_straight(const Statement& statement, int code) {
  const auto carry_out = [&] {
    if (turns(statement)) return turn(statement, code);
    const Motion motion = straight_motion(statement, state_, code == 0, assumed_);
    check_park(statement, true, state_.orientation.angles_deg);
    emit(statement, motion);
  };
  in_joints_if(statement.g(GGroup::non_modal) == 530, carry_out);
  cancel_length(statement, state_);
}

void Interpreter::cycle(const Statement& statement, int code) {
  check_system(statement, state_);
  check_tip(statement, state_);
  take_due_offsets(statement, state_);
  if (state_.is_adrift())
    statement.fail(statement.blamed(), "a canned cycle from a place that nothing states",
                   "a motion of each axis to a coordinate first");
  const ModalState& modal = state_.modal;
  const CycleMotions motions =
      cycles_.moves(statement, {code, modal.plane, modal.unit_mm, modal.incremental,
                                modal.return_to_r, state_.position_mm, spindle_state(),
                                modal.feed_mode == FeedMode::inverse_time, compensation_.active()});
  const std::array<bool, 3> known = state_.known;
  for (const CycleMove& move : motions.moves) {
    Motion motion;
    motion.kind = move.kind;
    motion.plane = modal.plane;
    motion.to = move.to_mm;
    motion.spindle_stopped = move.spindle_stopped;
    if (move.kind != MotionKind::rapid)
      motion.feed_mm_min = static_cast<float>(feed_of(statement, state_, 0));
    for (int axis = 0; axis < 3; ++axis) state_.known[axis] = known[axis] || move.stated[axis];
    emit(statement, motion);
  }
  state_.position_mm = motions.end_mm;
}

void Interpreter::check_count(const Statement& statement) const {
  if (motions_so_far() < most_motions_) return;
  statement.fail(statement.blamed(),
                 "the program makes more than " + std::to_string(most_motions_) + " motions",
                 "loops and cycles that make fewer");
}

/// `motion` is in the active work frame.
void Interpreter::emit(const Statement& statement, Motion motion) {
  check_count(statement);
  if (!compensation_.idle() && names_place(statement, state_.modal.plane))
    compensation_.name_place();
  send(statement.line(), motion);
}

/// `motion`, which may be made, stands in `line` of the main program.
void Interpreter::send(std::uint32_t line, Motion& motion) {
  motion.line = line;
  const Spindle& spindle = state_.spindle;
  if (spindle.on && (!*spindle.on || spindle.rpm == 0)) motion.spindle_stopped = true;
  if (motion.kind != MotionKind::rapid) note_spindle(motion);
  motion.position_known = state_.known[0] && state_.known[1] && state_.known[2];
  motion.height_known = state_.known[2];
  state_.has_moved = true;
  motion.parked = state_.adrift[2];
  motion.astray = state_.adrift[0] || state_.adrift[1];
  if (compensation_.idle()) {
    put(motion);
  } else {
    compensation_.move(motion);
  }
}

/// From the active work frame to the machine's. Nothing changes the frame while cutter compensation
/// holds motions.
void Interpreter::put(Motion& motion) {
  note_frame();
  if (!state_.orientation.plane) to_machine(motion);
  // Waited for the compensation while the program's first M3 or M4 came.
  if (program_.starts_spindle && program_.motions.size() < motions_before_spindle_)
    motion.spindle_stopped = true;
  if (state_.moved_tip) {
    state_.moved_tip->motion = program_.motions.size();
    program_.tip_places.push_back(*std::exchange(state_.moved_tip, std::nullopt));
  }
  program_.motions.push_back(motion);
}

void Interpreter::to_machine(Motion& motion) const {
  const Frame& frame = state_.frame;
  if (motion.kind == MotionKind::arc) {
    const auto [first, second, normal] = axes_of(motion.plane);
    Vec3 centre_mm;
    centre_mm[first] = motion.centre1;
    centre_mm[second] = motion.centre2;
    centre_mm = frame.to_machine(centre_mm);
    motion.centre1 = centre_mm[first];
    motion.centre2 = centre_mm[second];
  }
  motion.to = frame.to_machine(motion.to);
}

}  // namespace limitgauge::model::gcode
