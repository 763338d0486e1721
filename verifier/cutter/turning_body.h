#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "verifier/cutter/cutter_profile.h"
#include "verifier/cutter/swept_body.h"
#include "verifier/surface/bezier.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

struct TurnLook;
struct TurnStretch;

/// The space swept by a profile along one move that turns its axis as it goes: the tip straight and
/// evenly, the axis evenly along a great circle (model::ToolAxes). Its distance
///
///     d(s) = min over t in [0, 1] of D(s, t),    D(s, t) that to the profile as it stands at t,
///
/// is convex in s at each t, and not over all of them. Both bounds below are of second order in the
/// turn and in the size of the cell; CERTIFICATE.md, section 12, has the proofs.
class TurningBody {
 public:
  /// Unit vectors less than 180 degrees apart; the base of `profile`, which is the one that all
  /// questions have to be asked with, is `lift_mm` above the tip.
  TurningBody(const CutterProfile& profile, const model::Vec3& from, const model::Vec3& to,
              const model::Vec3& axis_from, const model::Vec3& axis_to, double lift_mm);

  model::Vec3 tip(double t) const { return from_ + delta_ * t; }
  model::Vec3 axis(double t) const;
  double turn_rad() const { return turn_rad_; }
  /// So short and turned by so little that bound() loses next to nothing.
  bool is_short() const {
    constexpr double kShort_mm = 0.5, kLittle_rad = 0.05;
    return core_speed_mm_ < kShort_mm && turn_rad_ < kLittle_rad;
  }
  /// Of the profile's core, about which it is looked at: the centre of a ball. And a box round
  /// where it is at all times.
  model::Vec3 core(double t) const { return tip(t) + axis(t) * up_mm_; }
  model::Box3 cores() const;

  /// A value of D at one time, no further above d than `slack_mm`, which is `precision_mm` at most
  /// as a rule, and its gradient: a plane under D at that time, not under d.
  struct Least {
    BodyDistance distance;
    double t = 0;
  };
  /// Where d is above `beyond_mm` the value is so too, and else says no more.
  Least least(const CutterProfile& profile, const model::Vec3& p,
              double beyond_mm = std::numeric_limits<double>::infinity(),
              double precision_mm = kAlongTurn_mm) const;
  /// A lower bound of d over all points no further from `p` along each axis than `half`, by one
  /// look at the middle of the move.
  double bound(const CutterProfile& profile, const model::Vec3& p, const model::Vec3& half) const;
  /// A lower bound of d over the hull of `points`, by planes at `middle`, which lies in it; not
  /// improved where it is `enough_mm`, or cannot be.
  double lower(const CutterProfile& profile, std::span<const model::Vec3> points,
               const model::Vec3& middle,
               double enough_mm = std::numeric_limits<double>::infinity()) const;
  /// At the control points of `cell`, a function that is convex and nowhere below d in their hull.
  void values(const CutterProfile& profile, const Bezier& cell, std::array<double, 16>& out) const;

 private:
  struct Around;
  struct LowerSearch;

  double nearest_on_chord(const model::Vec3& p) const;
  double bound_by_chord(const CutterProfile& profile, std::span<const model::Vec3> points,
                        const model::Vec3& middle, double bend) const;
  std::optional<Least> least_of_ball(const CutterProfile& profile, const model::Vec3& p,
                                     double bend, double beyond_mm, double precision_mm) const;
  BodyDistance standing(const CutterProfile& profile, const model::Vec3& p, double t) const;
  TurnLook look(const CutterProfile& profile, const model::Vec3& p, double t) const;
  static double next_look(const TurnStretch& stretch, bool by_tangents);
  /// A direction that turns with the tool, `by` of the move later.
  model::Vec3 turned(const model::Vec3& v, double by) const;
  /// No less than the second derivative by t of where the tool has a place that is so far from the
  /// core half-way.
  double bend_mm(double from_core_mm) const {
    return turn_rad_ * turn_rad_ * from_core_mm + bend_mm_;
  }
  void know_core();
  void following(const CutterProfile& profile, const Bezier& cell, const Least& at,
                 const Around& around, std::array<double, 16>& out) const;
  void rolling(const CutterProfile& profile, const Bezier& cell, double a, double b,
               std::array<double, 16>& out) const;

  model::Vec3 from_, delta_;
  model::Vec3 axis_, side_;  ///< where the move begins, and across it the way that it turns
  model::Vec3 end_axis_;     ///< where it ends
  model::Vec3 spin_rad_;     ///< the turn, about what it turns about
  double turn_rad_ = 0, lift_mm_ = 0;

  double up_mm_ = 0;  ///< of the core over the tip
  model::Vec3 core_from_, core_chord_,
      core_;  ///< where it begins, its way, and where it is half-way
  double core_speed_mm_ = 0, least_speed_mm_ = 0;  ///< no less than its speed by t, and no more
  double core_bend_mm_ = 0;                        ///< its second derivative by t
  double bend_mm_ = 0;                             ///< see bend_mm()
};

}  // namespace limitgauge::verifier
