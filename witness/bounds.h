#pragma once

#include "model/part/cage.h"

namespace limitgauge::witness {

/// A cage's sharpness as OpenSubdiv takes it. It keeps sharpness in single precision, where what is
/// a little below 10 becomes 10, which is sharp for ever: such a one is taken down instead, to the
/// next number below. What is a little above a whole number becomes that number, and would run out
/// a step early, which leaves other edges sharp at its ends: it is taken up to the next number
/// above. So both run out in the same step.
float in_single_precision(double sharpness);

/// How far two evaluators of the same limit surface may be apart if neither has a fault, in mm.
///
/// Rounding. Each refinement and each limit mask is a weighted mean with weights of at least zero,
/// of 2n + 1 points at most (n the greatest valence or number of corners). Such a step adds at most
/// (2n + 4)·2^-53 of the coordinates' size and enlarges no error that is there; so errors add up
/// over `steps`. The other evaluator is allowed `kEvaluation` of the coordinates' size.
///
/// Sharpness. The one step in which a sharpness s runs out blends two rules by its fraction. It is
/// off by what single precision does to s, and where m sharpnesses run out at one vertex,
/// OpenSubdiv takes their mean in single precision: m·2^-25 more. The two rules' points are no
/// further apart than the cage is large, and the steps after enlarge nothing. Different sharpnesses
/// run out in different steps, so this is counted once a step.
struct Bounds {
  double rounding_mm = 0, sharpness_mm = 0;
  double position_mm() const { return rounding_mm + sharpness_mm; }
};
Bounds bounds_of(const model::Cage& cage, int steps);

}  // namespace limitgauge::witness
