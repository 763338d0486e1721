#include "model/gcode/turning/turn_bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/angle.h"

namespace limitgauge::model {
namespace {

/// An axis between the tool and the workpiece, and which way it turns what comes before it.
struct TurnStep {
  RotaryAxis axis;
  double from_deg = 0, to_deg = 0;  ///< of the turn
  bool of_head = false;

  double rate() const { return radians(to_deg - from_deg); }
};

/// From the tool out: the heads, the one that another carries first, then the tables back, the one
/// that carries the other first.
std::vector<TurnStep> steps_of(const Kinematics& machine, const TurningMotion& motion) {
  std::vector<TurnStep> heads, tables;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const RotaryAxis& axis = machine.axes[i];
    const double from_deg = motion.from_deg[axis.index()], to_deg = motion.to_deg[axis.index()];
    if (machine.is_head(i)) {
      heads.insert(heads.begin(), {axis, from_deg, to_deg, true});
    } else {
      tables.push_back({axis, -from_deg, -to_deg, false});
    }
  }
  heads.insert(heads.end(), tables.begin(), tables.end());
  return heads;
}

/// A place that moves: a ball that it stays in, and bounds on how fast it goes and bends, by t.
struct MovingPlace {
  Vec3 centre_mm;
  double radius_mm = 0, speed_mm = 0, bend_mm = 0;

  void shift(const Vec3& from_mm, const Vec3& to_mm) {
    centre_mm += (from_mm + to_mm) / 2;
    radius_mm += distance(from_mm, to_mm) / 2;
    speed_mm += distance(from_mm, to_mm);
  }
  void turn(const TurnStep& step) {
    const double rate = std::abs(step.rate());
    const double off_mm = length(cross(step.axis.direction, centre_mm - step.axis.point_mm));
    const double farthest_mm = off_mm + radius_mm;
    bend_mm += rate * (rate * farthest_mm + 2 * speed_mm);
    speed_mm += rate * farthest_mm;
    radius_mm += 2 * off_mm * std::sin(std::min(rate, 2 * std::numbers::pi) / 4);
    centre_mm = step.axis.turn((step.from_deg + step.to_deg) / 2).point(centre_mm);
  }
};

double joints_bend_mm(const std::vector<TurnStep>& steps, const TurningMotion& motion) {
  const Vec3 tool{0, 0, -motion.frame.tool_length_mm};
  MovingPlace tip{tool};
  std::size_t i = 0;
  for (; i < steps.size() && steps[i].of_head; ++i) tip.turn(steps[i]);
  tip.shift(motion.from_mm - tool, motion.to_mm - tool);
  for (; i < steps.size(); ++i) tip.turn(steps[i]);
  return tip.bend_mm;
}

double dynamic_bend_mm(std::vector<TurnStep> steps, const TurningMotion& motion) {
  MovingPlace tip;
  tip.shift(motion.from_mm, motion.to_mm);
  for (TurnStep& step : steps) {
    step.axis.point_mm = motion.frame.work_zero_mm;
    if (!step.of_head) tip.turn(step);
  }
  return tip.bend_mm;
}

}  // namespace

TurnBend::TurnBend(const Kinematics& machine, const TurningMotion& motion) {
  const std::vector<TurnStep> steps = steps_of(machine, motion);
  Vec3 tool{0, 0, 1}, spin;
  for (const TurnStep& step : steps) {
    const double rate = step.rate();
    if (rate != 0 && ++turning_ == 1) {
      rate_ = std::abs(rate);
      across_ = length(cross(step.axis.direction, tool));
      along_ = std::abs(dot(step.axis.direction, tool));
    }
    const Pose turn = step.axis.turn(step.from_deg);
    tool = turn.direction(tool), spin = turn.direction(spin);
    twist_ += length(cross(spin, step.axis.direction * rate));
    spin += step.axis.direction * rate;
  }
  spin_ = length(spin);
  if (motion.frame.control == TipControl::joints) {
    tip_bend_mm_ = joints_bend_mm(steps, motion);
  } else if (motion.frame.control == TipControl::dynamic_offset) {
    tip_bend_mm_ = dynamic_bend_mm(steps, motion);
  } else {
    const double turn = motion.turn_rad();
    tip_bend_mm_ = turn * turn * std::abs(motion.frame.length_error_mm);
  }
}

double TurnBend::axis(double parts) const {
  if (turning_ == 0) return 0;
  const double h = 1 / parts;
  return turning_ == 1 ? one_axis(h) : two_axes(h);
}

namespace {

/// (1/cos(φ/2) - 1)/γ² against h²/8, where the angle is no more than this: it grows with it.
double beyond_straight(double angle) {
  if (angle < 1e-4) return 1 + angle * angle;  // 5/48 of that, and rounding
  return 8 / (angle * angle) * (1 / std::cos(angle / 2) - 1);
}

}  // namespace

/// On a small circle s is constant and τ = s·w·cos: what the great circle's angle lacks is known.
double TurnBend::one_axis(double h) const {
  const double turned = rate_ * h;
  const double by_turn = turned * across_;
  const double great =
      turned < std::numbers::pi ? 2 * std::asin(std::min(1.0, across_ * std::sin(turned / 2))) : 0;
  const double slower = std::max(0.0, (by_turn - great) * (by_turn + great));
  if (!(great < std::numbers::pi / 2) || turned > std::numbers::pi / 2) return by_turn * turned / 4;
  return std::hypot(turned * turned * across_ * along_, slower) / 8 * beyond_straight(great);
}

/// |u'|² = Ω² - (Ω·u)² with Ω of constant length, so τ ≤ |Ω'| + Ω²/2; |u'| changes by no more than
/// τh, and γ is no less than |u'| half-way less h/4 of the largest |u''|.
double TurnBend::two_axes(double h) const {
  const double spin2 = spin_ * spin_;
  const double tau = twist_ + spin2 / 2;
  const double bend = std::hypot(tau, spin2);
  if (spin_ * h > std::numbers::pi / 2) return (bend + spin2) * h * h / 8;
  const double uneven = std::min(spin2, 2 * spin_ * (tau + bend / 4) * h);
  return std::hypot(tau, uneven) * h * h / 8 * beyond_straight(spin_ * h);
}

TurningMotion part_of(const TurningMotion& motion, double from, double to) {
  TurningMotion part = motion;
  part.from_mm = motion.from_mm + (motion.to_mm - motion.from_mm) * from;
  part.to_mm = motion.from_mm + (motion.to_mm - motion.from_mm) * to;
  part.from_deg = motion.angles_at(from);
  part.to_deg = motion.angles_at(to);
  return part;
}

TurnPieces turn_pieces(const Kinematics& machine, const TurningMotion& motion, double reach_mm,
                       double limit_mm, double most) {
  constexpr double kWidest_rad = 0.5;
  const double sections = std::max(1.0, std::ceil(motion.turn_rad() / kWidest_rad));
  TurnPieces pieces;
  pieces.too_many = !(sections <= most);
  for (double i = 0; i < sections && !pieces.too_many; ++i) {
    const TurnBend bend(machine, part_of(motion, i / sections, (i + 1) / sections));
    const double wanted = std::sqrt(bend.place_mm(1, reach_mm) / limit_mm);
    pieces.too_many = !(static_cast<double>(pieces.ends.size()) + wanted < most);
    if (pieces.too_many) return pieces;
    double count = std::max(1.0, std::ceil(wanted));
    while (bend.place_mm(count, reach_mm) > limit_mm) ++count;
    for (double k = 1; k <= count; ++k) pieces.ends.push_back((i + k / count) / sections);
    pieces.error_mm = std::max(pieces.error_mm, bend.place_mm(count, reach_mm));
  }
  if (!pieces.too_many) pieces.ends.back() = 1;
  return pieces;
}

}  // namespace limitgauge::model
