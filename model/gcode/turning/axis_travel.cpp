#include "model/gcode/turning/axis_travel.h"

#include <algorithm>
#include <limits>

#include "model/base/tolerance.h"
#include "model/gcode/program_path.h"
#include "model/gcode/turning/turn_bend.h"

namespace limitgauge::model {
namespace {

/// Turned there and back, a place that stands on its limit is beyond it by rounding.
constexpr double kRounding_mm = 1e-6;

/// Which axes stand at places that are known.
struct Known {
  bool across = true, height = true;
};

Known known(const Motion& motion, const RotaryAngles& angles_deg) {
  if (motion.parked) return {!motion.astray, false};
  if (motion.height_known) return {};
  // A height that is not known is one of X and Y where the tool leans.
  return {angles_deg == RotaryAngles{}, false};
}

/// The farthest that X, Y and Z are beyond their limits; negative: within them by so much.
struct Overrun {
  int axis = 0;
  bool above = false;
  double mm = -std::numeric_limits<double>::infinity();
};

/// Goes through the motions of a program.
class TravelWalk {
 public:
  TravelWalk(const Program& program, const AxisTravel& travel)
      : program_(program), travel_(travel), at_mm_(travel.start_mm) {}

  std::vector<TravelBreach> beyond(std::size_t first, std::size_t last);

 private:
  void enter_frame_of(std::size_t motion);
  void look(const Motion& motion);
  void look_at_arc(const Motion& arc);
  void look_at_turn(const AxisTurn& turn, const Motion& motion);
  void look_along(const TurningMotion& turn, const Known& which);
  double speed_mm(const TurningMotion& turn) const;
  Overrun overrun(const Vec3& tip_mm, const RotaryAngles& angles_deg, const Known& which) const;
  Overrun overrun_at(const TurningMotion& turn, double t, const Known& which) const;
  void note(const Overrun& seen) {
    if (seen.mm > worst_.mm) worst_ = seen;
  }

  const Program& program_;
  const AxisTravel& travel_;
  std::size_t next_frame_ = 0;
  RotaryAngles angles_deg_{};
  Pose frame_;     ///< from what motions name to the workpiece
  Vec3 at_mm_;     ///< in it
  Overrun worst_;  ///< of the motion that is looked at
};

void TravelWalk::enter_frame_of(std::size_t motion) {
  for (; next_frame_ < program_.frames.size(); ++next_frame_) {
    const FrameChange& change = program_.frames[next_frame_];
    if (change.motion > motion) return;
    const Vec3 tip_mm = frame_.point(at_mm_);
    angles_deg_ = change.angles_deg;
    frame_ = change.frame.in_workpiece(travel_.machine, angles_deg_);
    at_mm_ = frame_.point_back(tip_mm);
  }
}

Overrun TravelWalk::overrun(const Vec3& tip_mm, const RotaryAngles& angles_deg,
                            const Known& which) const {
  const Vec3 aside_mm = travel_.machine.tip_aside_mm(angles_deg, travel_.tool_length_mm);
  const Vec3 at_mm =
      travel_.limits_from_machine.point(travel_.machine.table(angles_deg).point(tip_mm) - aside_mm);
  Overrun worst;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(axis == 2 ? which.height : which.across)) continue;
    const double below_mm = travel_.limits_mm.low[axis] - at_mm[axis];
    const double above_mm = at_mm[axis] - travel_.limits_mm.high[axis];
    const double out_mm = std::max(below_mm, above_mm);
    if (out_mm > worst.mm) worst = {axis, above_mm > below_mm, out_mm};
  }
  return worst;
}

Overrun TravelWalk::overrun_at(const TurningMotion& turn, double t, const Known& which) const {
  return overrun(turn.tool_at(travel_.machine, t).shift_mm, turn.angles_at(t), which);
}

void TravelWalk::look_at_arc(const Motion& arc) {
  const Arc sweep = arc_of(arc, at_mm_);
  const double chords = sweep.chords_within(kTravelLook_mm);
  for (double i = 0; i < chords; ++i)
    note(overrun(frame_.point(sweep.point_at(i / chords)), angles_deg_, {}));
}

/// Of X, Y and Z, by t: where the tip goes as the machine sees it, and how the heads take the tool
/// round their axes.
double TravelWalk::speed_mm(const TurningMotion& turn) const {
  double arm_mm = travel_.tool_length_mm;
  for (std::size_t i = 0; i < travel_.machine.axes.size(); ++i)
    if (travel_.machine.is_head(i)) arm_mm += 2 * length(travel_.machine.axes[i].point_mm);
  return turn.machine_tip_speed_mm(travel_.machine) +
         (travel_.machine.has_head() ? turn.turn_rad() * arm_mm : 0);
}

/// Halves of the time, as long as the axes may be farther out in one than they have been seen to
/// be; a tenth of that is not looked for. Joints that are named themselves go straight.
void TravelWalk::look_along(const TurningMotion& turn, const Known& which) {
  constexpr double kTenthMore = 1.1;
  note(overrun_at(turn, 1, which));
  if (turn.frame.control == TipControl::joints) return;
  struct Part {
    double middle, half;
  };
  const double speed = speed_mm(turn);
  std::vector<Part> parts = {{0.5, 0.5}};
  while (!parts.empty()) {
    const auto [middle, half] = parts.back();
    parts.pop_back();
    const Overrun seen = overrun_at(turn, middle, which);
    note(seen);
    if (!(seen.mm + speed * half > std::max(kTravelLook_mm, kTenthMore * worst_.mm))) continue;
    parts.push_back({middle - half / 2, half / 2});
    parts.push_back({middle + half / 2, half / 2});
  }
}

/// The axes turn evenly along an arc.
void TravelWalk::look_at_turn(const AxisTurn& turn, const Motion& motion) {
  Known which = known(motion, turn.turn.to_deg);
  which.height = which.height && !turn.parked;
  if (motion.kind != MotionKind::arc || turn.parked) return look_along(turn.turn, which);
  const Arc sweep = arc_of(motion, turn.turn.from_mm);
  const double chords = sweep.chords_within(kTravelLook_mm);
  Vec3 from_mm = turn.turn.from_mm;
  for (double i = 1; i <= chords; ++i) {
    TurningMotion chord = part_of(turn.turn, (i - 1) / chords, i / chords);
    chord.from_mm = from_mm;
    chord.to_mm = from_mm = i < chords ? sweep.point_at(i / chords) : motion.to;
    look_along(chord, which);
  }
}

void TravelWalk::look(const Motion& motion) {
  if (motion.kind == MotionKind::arc && !motion.parked) look_at_arc(motion);
  note(overrun(frame_.point(motion.to), angles_deg_, known(motion, angles_deg_)));
  at_mm_ = motion.to;
}

std::vector<TravelBreach> TravelWalk::beyond(std::size_t first, std::size_t last) {
  std::vector<TravelBreach> breaches;
  for (std::size_t i = 0; i < std::min(last, program_.motions.size()); ++i) {
    const Motion& motion = program_.motions[i];
    worst_ = {};
    enter_frame_of(i);
    if (const AxisTurn* turn = program_.turn_of(i)) {
      look_at_turn(*turn, motion);
      angles_deg_ = turn->turn.to_deg;
      frame_ = turn->turn.frame.in_workpiece(travel_.machine, angles_deg_);
      at_mm_ = turn->turn.to_mm;
    } else {
      look(motion);
    }
    if (i >= first && worst_.mm > kRounding_mm)
      breaches.push_back({i, motion.line, worst_.axis, worst_.above, worst_.mm});
  }
  return breaches;
}

}  // namespace

std::vector<TravelBreach> beyond_travel(const Program& program, const AxisTravel& travel,
                                        std::size_t first, std::size_t last) {
  return TravelWalk(program, travel).beyond(first, last);
}

}  // namespace limitgauge::model
