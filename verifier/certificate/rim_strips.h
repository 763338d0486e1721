#pragma once

#include "verifier/certificate/run_bounds.h"
#include "verifier/reach/reach_query.h"

namespace limitgauge::verifier {

/// Proofs for flat cells of S on which what was cut ends where the cutter's reach does, as in the
/// corner of a pocket that was cut clean: there material stands right behind the rim, so that
/// halves of a cell are proven on one side or the other only once they are as small as the strip in
/// which both hold. That strip is short across the rim and long along it, whichever way it lies to
/// the cell's parameters.
class RimStrips {
 public:
  RimStrips(RunBounds& bounds, const ReachQuery& reach, ReachMemory& memory)
      : bounds_(bounds), reach_(reach), memory_(memory) {}

  /// Proof that no place of the cell has a run longer than `length_mm` unless it cannot be touched:
  /// in a rectangle that holds the cell and lies along the rim, the strip nearest to what was cut
  /// has no longer run, and what is left is out of reach. False means "not proven", none that no
  /// such rim was found.
  std::optional<bool> surely_within(const OffsetCell& cell, double allowance_mm, double length_mm);

 private:
  /// A rectangle in the cell's plane, x counted across the rim, outwards.
  struct Frame {
    model::Vec3 origin, across, along, normal;
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    Bezier strip(double from_x, double to_x) const;
  };
  std::optional<Frame> frame_of(const OffsetCell& cell, double t_mm);
  double gone_up_to(const Frame& frame, double length_mm);
  bool unreachable_between(const Frame& frame, double from_x, double to_x, int splits);

  RunBounds& bounds_;
  const ReachQuery& reach_;
  ReachMemory& memory_;
};

}  // namespace limitgauge::verifier
