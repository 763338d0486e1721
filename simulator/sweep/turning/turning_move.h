#pragma once

#include <limits>
#include <optional>

#include "simulator/sweep/swept_distance.h"

namespace limitgauge::simulator {

/// A straight move of a cutter's tip during which its axis turns evenly along a great circle
/// (model::ToolAxes). The cutter is looked at about its core, a place on its axis: the centre of a
/// ball, of a corner's arc.
struct TurningMove {
  TurningMove() = default;
  /// Unit vectors no more than 90 degrees apart; `core_mm` is how far the core is above the tip.
  TurningMove(const model::Vec3& from, const model::Vec3& to, const model::Vec3& axis_from,
              const model::Vec3& axis_to, double core_mm);

  model::Vec3 tip(double t) const { return start + delta * t; }
  model::Vec3 up(double t) const;  ///< the axis, from the tip to the spindle
  model::Vec3 core(double t) const { return tip(t) + up(t) * core_mm; }
  /// No place is farther from the core at any time than from that half-way and this.
  double half_way_mm() const { return core_speed_mm / 2; }

  model::Vec3 start, delta;  ///< of the tip, mm
  model::Vec3 axis, side;    ///< at the start, and across it the way that it turns
  model::Vec3 axis_half_way, axis_end, core_half_way;
  double turn_rad = 0;
  double core_mm = 0;
  double core_speed_mm = 0;  ///< the core is never faster, by t
};

/// d(p) = least over the move of the signed distance D(p, t) to the fluted part as it stands at t:
/// negative inside what is swept, there minus the depth in the cutter where that is deepest, exact
/// outside. 1-Lipschitz, but not convex in p. Proofs: simulator/PROOFS.md, P9 to P11.
///
/// The value is D at the time `t` of the sample, never below d and no more than
/// kLeastAlongMove_mm above it, or `within_mm` where that is more. Nothing where d is proven not to
/// be below `bound`; that is the one thing that `bound` changes. `gradient` is D's at t, or, where
/// two faces of the cutter meet there, a mean of both; `slack_mm` is what turning_sag starts from.
std::optional<SweptSample> turning_distance(const CutterProfile& profile, const TurningMove& move,
                                            const model::Vec3& p,
                                            double bound = std::numeric_limits<double>::infinity(),
                                            double within_mm = 0);

/// The distance to the cutter as it stands at t, and its gradient.
SweptSample standing_distance(const CutterProfile& profile, const TurningMove& move,
                              const model::Vec3& p, double t);

/// True where one look shows that d(p) is not below `bound`. False says nothing.
bool cannot_be_below(const CutterProfile& profile, const TurningMove& move, const model::Vec3& p,
                     double bound);

/// e such that d(p + δ) >= d(p) + gradient·δ − e for all |δ| <= reach, `at` being the sample at p:
/// what a plane under d costs, d not being convex. In mm.
double turning_sag(const CutterProfile& profile, const TurningMove& move, const model::Vec3& p,
                   const SweptSample& at, double reach);

/// As those for moves that do not turn, of the cutter as it stands at the sample's time.
double curvature_bound(const CutterProfile& profile, const TurningMove& move, const model::Vec3& p,
                       const SweptSample& at, double reach);
double outside_bound(const CutterProfile& profile, const TurningMove& move, const model::Vec3& p,
                     const SweptSample& at, const model::Vec3& half);

}  // namespace limitgauge::simulator
