#include "model/gcode/turning/turning_path_maker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/base/error.h"
#include "model/base/tolerance.h"
#include "model/gcode/program_path.h"
#include "model/gcode/turning/turn_bend.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr Vec3 kSpindle{0, 0, 1};
/// Within rounding of places turned back and forth.
constexpr double kSamePlace_mm = 1e-9;

float tip_feed(double way_mm, double minutes, float stated_mm_min) {
  if (way_mm == 0 || minutes == 0) return stated_mm_min;
  return static_cast<float>(std::clamp(way_mm / minutes, kLeastFeed_mm_min, kLargestFeed_mm_min));
}

void require_turning_options(const PathOptions& options) {
  if (!(std::isfinite(options.chord_error_mm) && options.chord_error_mm > 0))
    throw std::invalid_argument("chord error must be greater than 0");
  if (!(std::isfinite(options.reach_mm) && options.reach_mm >= 0))
    throw std::invalid_argument("a tool's reach is finite and not negative");
  if (options.first == 0 && !options.start_mm)
    throw std::invalid_argument("a path that turns its tool begins at a stated start");
}

/// CL data name the tool's axis with each place.
TurningPath stated_path(const Program& program, const PathOptions& options) {
  const std::size_t last = std::min(options.last, program.motions.size());
  const std::size_t first = std::min(options.first, last);
  PathOptions upright = options;
  upright.kinematics.reset();
  TurningPath out{tip_path(program, upright), {}};
  const RigidPlacement turn{options.machine_in_part.rotate_z_deg, {}};
  out.axes.start = turn(axis_from(*program.axes, first));
  for (std::size_t i = first; i < last; ++i) out.axes.to.push_back(turn(program.axes->to[i]));
  return out;
}

}  // namespace

TurningPathMaker::TurningPathMaker(const Program& program, const PathOptions& options)
    : program_(program),
      options_(options),
      machine_(options.kinematics.value()),
      placed_(pose_of(options.machine_in_part)),
      height_mm_(park_height_mm()) {}

/// Above the ball that everything stays in while the tables turn it, and by the tool's own length
/// more where a head may swing it.
double TurningPathMaker::park_height_mm() const {
  if (options_.around_mm.empty()) return options_.park_z_mm;
  const Box3 box = placed_.inverse().box(options_.around_mm);
  double height_mm = box.high.z;
  const RotaryAxis* outer = nullptr;
  for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
    const RotaryAxis& axis = machine_.axes[i];
    if (machine_.is_head(i)) {
      height_mm += 2 * (options_.reach_mm + length(axis.point_mm));
      continue;
    }
    if (!outer) outer = &axis;
    double farthest_mm = distance(axis.point_mm, outer->point_mm);
    farthest_mm += length(box.size()) / 2 + distance(axis.point_mm, (box.low + box.high) / 2);
    height_mm = std::max(height_mm, outer->point_mm.z + farthest_mm);
  }
  return height_mm;
}

void TurningPathMaker::stand(const RotaryAngles& angles_deg) {
  angles_deg_ = angles_deg;
  axis_ = normalized(placed_.direction(machine_.stand({}, angles_deg, 0).axis));
}

/// The frame that motion `motion` names places in.
void TurningPathMaker::enter_frame_of(std::size_t motion) {
  const FrameChange* entered = nullptr;
  for (; next_frame_ < program_.frames.size(); ++next_frame_) {
    if (program_.frames[next_frame_].motion > motion) break;
    entered = &program_.frames[next_frame_];
  }
  if (!entered) return;
  stand(entered->angles_deg);
  frame_ = entered->frame.in_workpiece(machine_, entered->angles_deg);
  if (!parked_) at_mm_ = frame_.point_back(here_in_workpiece());
}

/// Where the motion before has left the tool.
void TurningPathMaker::begin(std::size_t first) {
  at_mm_ = first == 0 ? options_.start_mm.value() : program_.motions[first - 1].to;
  parked_ = false;
  if (const AxisTurn* turn = first > 0 ? program_.turn_of(first - 1) : nullptr) {
    stand(turn->turn.to_deg);
    frame_ = turn->turn.frame.in_workpiece(machine_, angles_deg_);
    at_mm_ = turn->turn.to_mm;
    parked_ = turn->parked;
  } else if (first > 0) {
    path_.start = placed(at_mm_);
    enter_frame_of(first - 1);
    at_mm_ = program_.motions[first - 1].to;
    parked_ = program_.motions[first - 1].parked;
  } else {
    stand({});
  }
  path_.start = parked_ ? parked_place(on_machine(at_mm_)) : placed(at_mm_);
  axes_.start = axis_;
}

/// Where another tool's tip has come to stand.
void TurningPathMaker::change_tool(const TipPlace& tip) {
  if (parked_) return;
  const Vec3 part_mm = placed_.point(tip.at_mm);
  if (path_.moves.empty()) {
    path_.start = part_mm;
  } else {
    add_straight(at_change(tip), part_mm, true);
  }
  at_mm_ = frame_.point_back(tip.at_mm);
}

Vec3 TurningPathMaker::on_machine(const Vec3& named_mm) const {
  return machine_.table(angles_deg_).point(frame_.point(named_mm));
}

/// In the part's frame; never lower than it is.
Vec3 TurningPathMaker::parked_place(Vec3 machine_mm) const {
  machine_mm.z = std::max(machine_mm.z, height_mm_);
  return placed_.point(machine_.table(angles_deg_).point_back(machine_mm));
}

/// Above where the tool stands.
Vec3 TurningPathMaker::raised() const {
  return parked_place(machine_.table(angles_deg_).point(here_in_workpiece()));
}

void TurningPathMaker::require_room(double moves, std::uint32_t line) const {
  if (static_cast<double>(path_.moves.size()) + moves <= options_.most_moves) return;
  throw ResourceError("line " + std::to_string(line) + " of the program: more than " +
                      std::to_string(std::llround(options_.most_moves / 1e6)) +
                      " million moves at a chord error of " + shortest(options_.chord_error_mm) +
                      " mm; a wider verification.resolution needs fewer");
}

void TurningPathMaker::note_error(double error_mm) {
  path_.chord_error_mm = std::max(path_.chord_error_mm, error_mm);
}

void TurningPathMaker::add_move(const Motion& motion, const Vec3& part_mm, const Vec3& axis,
                                bool rapid) {
  path_.moves.emplace_back(part_mm, rapid ? 0.0F : motion.feed_mm_min, motion.line,
                           rapid ? MoveKind::rapid : MoveKind::feed);
  path_.moves.back().spindle_stopped = motion.spindle_stopped;
  axes_.to.push_back(axis);
}

void TurningPathMaker::add_arc(const Motion& arc) {
  const Arc sweep = arc_of(arc, at_mm_);
  const double chords = sweep.chords_within(options_.chord_error_mm);
  require_room(chords, arc.line);
  note_error(sweep.error_mm(chords));
  for (double i = 1; i < chords; ++i) add_straight(arc, placed(sweep.point_at(i / chords)), false);
  add_straight(arc, placed(arc.to), false);
}

/// Up first, then across, along the machine's Z.
void TurningPathMaker::park(const Motion& motion) {
  if (!parked_) add_straight(motion, raised(), true);
  const Vec3 to_mm = parked_place(on_machine(motion.to));
  if (distance(here(), to_mm) > kSamePlace_mm) add_straight(motion, to_mm, true);
}

void TurningPathMaker::add(const Motion& motion) {
  require_room(2, motion.line);
  if (motion.parked) {
    park(motion);
  } else if (motion.kind == MotionKind::arc && !parked_) {
    add_arc(motion);
  } else {
    add_straight(motion, placed(motion.to), motion.kind == MotionKind::rapid);
  }
  at_mm_ = motion.to;
  parked_ = motion.parked;
}

/// The moves of a turn, their error.
double TurningPathMaker::add_turn(const Turn& turn) {
  const double room = options_.most_moves - static_cast<double>(path_.moves.size());
  const TurnPieces pieces =
      turn_pieces(machine_, turn.turning, options_.reach_mm, turn.limit_mm, room);
  if (pieces.too_many) require_room(room + 1, turn.motion.line);
  const bool rapid = turn.motion.kind == MotionKind::rapid;
  double before = 0;
  for (const double t : pieces.ends) {
    const Vec3 from_mm = here();
    const Pose tool = placed_ * turn.turning.tool_at(machine_, t);
    add_move(turn.motion, tool.shift_mm, normalized(tool.direction(kSpindle)), rapid);
    if (!rapid)
      path_.moves.back().feed_mm_min = tip_feed(
          distance(from_mm, tool.shift_mm), turn.minutes * (t - before), turn.motion.feed_mm_min);
    before = t;
  }
  return pieces.error_mm;
}

/// Above everything: what the tables take with them passes below the tool.
void TurningPathMaker::swing(const AxisTurn& turn, const Motion& motion) {
  if (!parked_) add_straight(motion, raised(), true);
  const Vec3 from_mm = machine_.table(angles_deg_).point(here_in_workpiece());
  stand(turn.turn.to_deg);
  frame_ = turn.turn.frame.in_workpiece(machine_, angles_deg_);
  Vec3 to_mm = on_machine(turn.turn.to_mm);
  to_mm.z = from_mm.z;
  TurningMotion swung = turn.turn;
  swung.frame = {TipControl::joints, turn.turn.frame.tool_length_mm, {}, {}};
  const double length_mm = swung.frame.tool_length_mm;
  swung.from_mm = from_mm - machine_.tip_aside_mm(swung.from_deg, length_mm);
  swung.to_mm = to_mm - machine_.tip_aside_mm(swung.to_deg, length_mm);
  Motion rapid = motion;
  rapid.kind = MotionKind::rapid;
  note_error(add_turn({rapid, swung, 0, options_.chord_error_mm}));
}

/// Each chord turns its share, and what it is off the arc is off in the part too: at the same time
/// both are carried alike.
void TurningPathMaker::turn_arc(const AxisTurn& turn, const Motion& arc) {
  const double half_mm = options_.chord_error_mm / 2;
  const Arc sweep = arc_of(arc, turn.turn.from_mm);
  double chords = sweep.chords_within(half_mm);
  while (chords < options_.most_moves && sweep.even_error_mm(chords) > half_mm) ++chords;
  require_room(chords, arc.line);
  double worst_mm = 0;
  Vec3 from_mm = turn.turn.from_mm;
  for (double i = 1; i <= chords; ++i) {
    TurningMotion chord = part_of(turn.turn, (i - 1) / chords, i / chords);
    chord.from_mm = from_mm;
    chord.to_mm = from_mm = i < chords ? sweep.point_at(i / chords) : arc.to;
    worst_mm = std::max(worst_mm, add_turn({arc, chord, turn.minutes / chords, half_mm}));
  }
  note_error(worst_mm + sweep.even_error_mm(chords));
}

void TurningPathMaker::turn(const AxisTurn& turn, const Motion& motion) {
  require_room(2, motion.line);
  if (turn.parked) {
    swing(turn, motion);
  } else if (motion.kind == MotionKind::arc && !parked_) {
    turn_arc(turn, motion);
  } else {
    TurningMotion turning = turn.turn;
    // A parked tool, or one that another length has put elsewhere, goes on from where it stands.
    const Vec3 from_mm =
        turning.frame.in_workpiece(machine_, turning.from_deg).point_back(here_in_workpiece());
    if (distance(from_mm, turning.from_mm) > kSamePlace_mm) turning.from_mm = from_mm;
    note_error(add_turn({motion, turning, turn.minutes, options_.chord_error_mm}));
  }
  stand(turn.turn.to_deg);
  frame_ = turn.turn.frame.in_workpiece(machine_, angles_deg_);
  at_mm_ = turn.turn.to_mm;
  parked_ = turn.parked;
}

TurningPath TurningPathMaker::make() {
  const std::size_t last = std::min(options_.last, program_.motions.size());
  const std::size_t first = std::min(options_.first, last);
  begin(first);
  for (std::size_t i = first; i < last; ++i) {
    if (const TipPlace* tip = program_.tip_place_of(i)) change_tool(*tip);
    enter_frame_of(i);
    const AxisTurn* turned = program_.turn_of(i);
    if (turned) {
      turn(*turned, program_.motions[i]);
    } else {
      add(program_.motions[i]);
    }
  }
  return {std::move(path_), std::move(axes_)};
}

TurningPath to_turning_path(const Program& program, const PathOptions& options) {
  require_turning_options(options);
  TurningPath made =
      program.axes ? stated_path(program, options) : TurningPathMaker(program, options).make();
  require_axes(made.path, made.axes);
  return made;
}

}  // namespace limitgauge::model
