#pragma once

#include <vector>

#include "model/machine/turning_motion.h"

namespace limitgauge::model {

/// How a motion that turns rotary axes bends: bounds on how far it is from moves whose tip goes
/// straight and whose axis goes evenly along a great circle, between places that it goes through.
///
/// A rotary axis takes a place x of what it carries to y = P + R(x - P), R turning at the constant
/// rate w, so that |y'| ≤ w·ρ + |x'| and |y''| ≤ w²·ρ + 2w·|x'| + |x''| for the farthest ρ that x
/// gets from its line. From the tool out to the workpiece that bounds the tip's y'' by b; between
/// the ends of a part h of t a straight line differs from it by b·h²/8 at most.
///
/// The axis u has |u'| = s and u'' = τ - s²u, τ across u. The great circle g has g'' = -γ²g, γh its
/// angle φ. d = u - g vanishes at both ends, and d'' + γ²d = τ + (γ² - s²)u; Green's function of
/// the left side is positive for φ < π, so |d| ≤ max|τ + (γ² - s²)u| · (1/cos(φ/2) - 1)/γ².
class TurnBend {
 public:
  TurnBend(const Kinematics& machine, const TurningMotion& motion);

  /// Over each of `parts` equal parts of the motion, and at each t: the distance of the tip from a
  /// straight line, mm.
  double tip_mm(double parts) const { return tip_bend_mm_ / (8 * parts * parts); }
  /// ... and the length of the difference of the tool's axis, of length 1, from that on the great
  /// circle.
  double axis(double parts) const;
  /// ... and how far any place of the tool within `reach_mm` of its tip is from where it is taken
  /// to be. The turn that takes one axis to the other moves no place farther than that.
  double place_mm(double parts, double reach_mm) const {
    return tip_mm(parts) + axis(parts) * reach_mm;
  }

 private:
  double one_axis(double h) const;
  double two_axes(double h) const;

  double tip_bend_mm_ = 0;
  int turning_ = 0;  ///< how many axes turn
  /// Of one axis: s, constant, and what the turn and s are of it as the tool leans.
  double rate_ = 0, across_ = 0, along_ = 0;
  /// Of two: the length of their rates' sum, which is constant, and the rate at which it turns.
  double spin_ = 0, twist_ = 0;
};

/// Parts of a motion, each of which is taken for a move of straight tip and great-circle axis.
struct TurnPieces {
  std::vector<double> ends;  ///< t; the last is 1
  double error_mm = 0;       ///< TurnBend::place_mm of the worst
  bool too_many = false;     ///< and `ends` are not all
};
/// Pieces that turn by half a radian at most and keep TurnBend::place_mm within `limit_mm`, where
/// `most` are enough for that.
TurnPieces turn_pieces(const Kinematics& machine, const TurningMotion& motion, double reach_mm,
                       double limit_mm, double most);

/// The motion from `from` to `to` of `motion`'s t.
TurningMotion part_of(const TurningMotion& motion, double from, double to);

}  // namespace limitgauge::model
