#include "model/gcode/program_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "model/base/angle.h"
#include "model/base/error.h"
#include "model/base/tolerance.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

/// Lays the motions of a program into the part's frame, one after the other.
class PathMaker {
 public:
  PathMaker(const PathOptions& options, std::size_t motions)
      : options_(options), as_it_is_(options.machine_in_part == RigidPlacement()) {
    path_.moves.reserve(motions);
  }

  /// Where `motion` ends.
  void begin_behind(const Motion& motion);
  /// Where a turn of rotary axes has left the tool.
  void begin_behind(const AxisTurn& turn);
  /// Where another tool's tip has come to stand.
  void change_tool(const TipPlace& tip);
  /// The motions from here on lie as `frame` says.
  void enter(const FrameChange& frame);
  void begin_at(const Vec3& machine_mm);
  void add(const Motion& motion);
  Toolpath take() { return std::move(path_); }

 private:
  Vec3 placed(const Vec3& machine_mm) const {
    if (pose_) return pose_->point(machine_mm);
    return as_it_is_ ? machine_mm : options_.machine_in_part(machine_mm);
  }
  Vec3 here() const { return path_.moves.empty() ? path_.start : path_.moves.back().to; }
  /// As high as that by a motion of the machine's Z, which leans where a head is turned.
  Vec3 at_park_height(const Vec3& machine_mm) const {
    const Vec3 p = placed(machine_mm);
    return p + up_ * ((options_.park_z_mm - p.z) / up_.z);
  }
  void turn_up(const RotaryAngles& angles_deg);
  void approach(const Motion& rapid);
  void add_move(const Motion& motion, const Vec3& part_mm, bool rapid);
  void add_arc(const Motion& arc);
  void park(const Motion& motion);

  const PathOptions& options_;
  bool as_it_is_;
  std::optional<Pose> pose_;  ///< of motions in the path's frame, on a machine with rotary axes
  Vec3 up_{0, 0, 1};          ///< the machine's +Z in the path's frame
  Toolpath path_;
  Vec3 at_mm_;  ///< in the frame of motions
  bool started_ = false, parked_ = false;
};

void PathMaker::begin_behind(const Motion& motion) {
  begin_at(motion.to);
  parked_ = motion.parked;
  if (parked_) path_.start = at_park_height(at_mm_);
}

void PathMaker::begin_behind(const AxisTurn& turn) {
  const Kinematics& machine = options_.kinematics.value();
  pose_ = pose_of(options_.machine_in_part) * turn.turn.frame.upright(machine, turn.turn.to_deg);
  turn_up(turn.turn.to_deg);
  begin_at(turn.turn.to_mm);
  parked_ = turn.parked;
  if (parked_) path_.start = at_park_height(at_mm_);
}

/// What the change has put in is followed down or up to where it stands, which is on its way.
void PathMaker::change_tool(const TipPlace& tip) {
  if (!started_ || parked_) return;
  const std::optional<Kinematics>& machine = options_.kinematics;
  const Vec3 part_mm =
      machine
          ? (pose_of(options_.machine_in_part) * machine->upright(tip.angles_deg)).point(tip.at_mm)
          : placed(tip.at_mm);
  if (path_.moves.empty()) {
    path_.start = part_mm;
  } else {
    add_move(at_change(tip), part_mm, true);
  }
  at_mm_ = pose_ ? pose_->point_back(part_mm) : tip.at_mm;
}

void PathMaker::turn_up(const RotaryAngles& angles_deg) {
  const Vec3 of_tool = options_.kinematics.value().head(angles_deg).direction_back({0, 0, 1});
  up_ = pose_of(options_.machine_in_part).direction(of_tool);
}

void PathMaker::enter(const FrameChange& frame) {
  turn_up(frame.angles_deg);
  pose_ = pose_of(options_.machine_in_part) *
          frame.frame.upright(options_.kinematics.value(), frame.angles_deg);
  if (started_) at_mm_ = pose_->point_back(here());
}

void PathMaker::begin_at(const Vec3& machine_mm) {
  at_mm_ = machine_mm;
  parked_ = false;
  started_ = true;
  path_.start = placed(at_mm_);
}

/// A rapid of a program whose start nobody asks for.
void PathMaker::approach(const Motion& rapid) {
  begin_behind(rapid);
  started_ = rapid.position_known;
}

void PathMaker::add_move(const Motion& motion, const Vec3& part_mm, bool rapid) {
  path_.moves.emplace_back(part_mm, rapid ? 0.0F : motion.feed_mm_min, motion.line,
                           rapid ? MoveKind::rapid : MoveKind::feed);
  path_.moves.back().spindle_stopped = motion.spindle_stopped;
}

void PathMaker::add_arc(const Motion& arc) {
  const Arc sweep = arc_of(arc, at_mm_);
  const double chords = sweep.chords_within(options_.chord_error_mm);
  const auto count = static_cast<std::size_t>(chords);
  if (static_cast<double>(path_.moves.size()) + chords > options_.most_moves)
    throw ResourceError("line " + std::to_string(arc.line) + " of the program: more than " +
                        std::to_string(std::llround(options_.most_moves / 1e6)) +
                        " million moves at a chord error of " + shortest(options_.chord_error_mm) +
                        " mm; a wider verification.resolution needs fewer");
  path_.chord_error_mm = std::max(path_.chord_error_mm, sweep.error_mm(chords));
  path_.arcs.push_back({turned(sweep, pose_ ? *pose_ : pose_of(options_.machine_in_part)),
                        static_cast<std::uint32_t>(path_.moves.size()),
                        static_cast<std::uint32_t>(count)});
  for (std::size_t i = 1; i < count; ++i)
    add_move(arc, placed(sweep.point_at(static_cast<double>(i) / chords)), false);
  add_move(arc, placed(arc.to), false);
}

/// Up first, then across: what the tool meets on its way to a place that nobody states must not
/// depend on that place.
void PathMaker::park(const Motion& motion) {
  if (!parked_) add_move(motion, at_park_height(at_mm_), true);
  if (motion.to.x != at_mm_.x || motion.to.y != at_mm_.y)
    add_move(motion, at_park_height(motion.to), true);
}

void PathMaker::add(const Motion& motion) {
  if (!started_) {
    if (motion.kind == MotionKind::rapid) return approach(motion);
    begin_at(at_mm_);
  }
  if (motion.parked) {
    park(motion);
  } else if (motion.kind == MotionKind::arc && !parked_) {
    add_arc(motion);
  } else {
    add_move(motion, placed(motion.to), motion.kind == MotionKind::rapid);
  }
  at_mm_ = motion.to;
  parked_ = motion.parked;
}

}  // namespace

Vec3 RigidPlacement::operator()(const Vec3& p) const {
  return turned(p, rotate_z_deg) + translate_mm;
}

RigidPlacement machine_in_part(const RigidPlacement& program_frame, const WorkOffset& g54) {
  RigidPlacement placement{program_frame.rotate_z_deg - g54.rotation_deg, {}};
  placement.translate_mm = program_frame.translate_mm - placement(g54.origin_mm);
  return placement;
}

Pose pose_of(const RigidPlacement& placement) {
  Pose pose = turn_about({0, 0, 1}, placement.rotate_z_deg);
  pose.shift_mm = placement.translate_mm;
  return pose;
}

Pose turned_part(const Kinematics& machine, const RigidPlacement& machine_in_part,
                 const RotaryAngles& angles_deg) {
  const Pose placed = pose_of(machine_in_part);
  return placed * machine.upright(angles_deg) * placed.inverse();
}

namespace {

/// The frames of motions from `first` on, as a path comes to them.
class FrameWalk {
 public:
  explicit FrameWalk(const Program& program) : frames_(program.frames) {}

  /// Calls `enter` with the frame that motion `motion` is in, where it is another than before.
  template <typename Enter>
  void go_to(std::size_t motion, const Enter& enter) {
    const std::size_t before = next_;
    while (next_ < frames_.size() && frames_[next_].motion <= motion) ++next_;
    if (next_ != before) enter(frames_[next_ - 1]);
  }

 private:
  const std::vector<FrameChange>& frames_;
  std::size_t next_ = 0;
};

const AxisTurn* turn_at(const Program& program, std::size_t motion) {
  const auto found =
      std::lower_bound(program.turns.begin(), program.turns.end(), motion,
                       [](const AxisTurn& turn, std::size_t at) { return turn.motion < at; });
  return found != program.turns.end() && found->motion == motion ? &*found : nullptr;
}

}  // namespace

Motion at_change(const TipPlace& tip) {
  Motion motion;
  motion.line = tip.line;
  motion.spindle_stopped = true;
  return motion;
}

Arc arc_of(const Motion& motion, const Vec3& start) {
  const auto [first, second, normal] = axes_of(motion.plane);
  const double x1 = start[first] - motion.centre1, y1 = start[second] - motion.centre2;
  const double x2 = motion.to[first] - motion.centre1, y2 = motion.to[second] - motion.centre2;
  const double direction = motion.turns < 0 ? -1 : 1;
  Arc arc;
  arc.centre[first] = motion.centre1, arc.centre[second] = motion.centre2;
  arc.centre[normal] = start[normal];
  arc.axis1[first] = arc.axis2[second] = 1;
  arc.rise_mm[normal] = motion.to[normal] - start[normal];
  arc.angle = std::atan2(y1, x1);
  double forward = direction * (std::atan2(y2, x2) - arc.angle);
  while (forward < kFullTurn_rad) forward += 2 * std::numbers::pi;
  forward += 2 * std::numbers::pi * (std::max(1.0, std::abs(motion.turns)) - 1);
  arc.swept = direction * forward;
  arc.radius_mm = std::hypot(x1, y1);
  arc.radius_growth_mm = std::hypot(x2, y2) - arc.radius_mm;
  return arc;
}

Toolpath to_toolpath(const Program& program, const PathOptions& options) {
  if (program.axes)
    throw std::invalid_argument("the program turns its tool: its path has axes (to_turning_path)");
  return tip_path(program, options);
}

Toolpath tip_path(const Program& program, const PathOptions& options) {
  if (!(std::isfinite(options.chord_error_mm) && options.chord_error_mm > 0))
    throw std::invalid_argument("chord error must be greater than 0");
  const std::size_t last = std::min(options.last, program.motions.size());
  const std::size_t first = std::min(options.first, last);
  PathMaker maker(options, last - first);
  FrameWalk frames(program);
  const auto enter = [&](const FrameChange& frame) { maker.enter(frame); };
  if (first == 0 && options.start_mm) maker.begin_at(*options.start_mm);
  if (const AxisTurn* turn = first > 0 ? turn_at(program, first - 1) : nullptr) {
    maker.begin_behind(*turn);
  } else if (first > 0) {
    if (options.kinematics) frames.go_to(first - 1, enter);
    maker.begin_behind(program.motions[first - 1]);
  }
  for (std::size_t i = first; i < last; ++i) {
    if (const TipPlace* tip = program.tip_place_of(i)) maker.change_tool(*tip);
    if (options.kinematics) frames.go_to(i, enter);
    maker.add(program.motions[i]);
  }
  return maker.take();
}

std::vector<SteadyRange> steady_ranges(const Program& program, std::size_t first,
                                       std::size_t last) {
  std::vector<SteadyRange> ranges(1);
  ranges.back().first = first;
  for (const AxisTurn& turn : program.turns) {
    if (turn.motion < first) ranges.back().angles_deg = turn.turn.to_deg;
    if (turn.motion < first || turn.motion >= last) continue;
    SteadyRange& open = ranges.back();
    open.last = turn.motion;
    // What moves nothing between two turns is no range.
    if (open.last > open.first) ranges.emplace_back();
    ranges.back().turns.push_back(turn);
    ranges.back().angles_deg = turn.turn.to_deg;
    ranges.back().first = turn.motion + 1;
  }
  ranges.back().last = last;
  return ranges;
}

Toolpath to_toolpath(const Program& program, double chord_error_mm) {
  PathOptions options;
  options.chord_error_mm = chord_error_mm;
  return to_toolpath(program, options);
}

double highest_z_mm(const Program& program, const RigidPlacement& machine_in_part) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Motion& motion : program.motions)
    if (motion.height_known)
      highest = std::max(highest, motion.to.z + machine_in_part.translate_mm.z);
  return highest;
}

std::string to_text(const Motion& motion) {
  std::string text = std::to_string(motion.line);
  const auto add = [&text](double value) { text.append(" ").append(shortest(value)); };
  const bool arc = motion.kind == MotionKind::arc;
  text += arc ? " arc " : motion.kind == MotionKind::rapid ? " rapid" : " feed";
  if (arc) text += std::to_string(static_cast<int>(motion.plane));
  for (const int axis : {0, 1, 2}) add(motion.to[axis]);
  if (!arc) return text;
  for (const double value : {motion.centre1, motion.centre2, motion.turns}) add(value);
  return text;
}

}  // namespace limitgauge::model
