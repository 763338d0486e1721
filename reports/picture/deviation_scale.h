#pragma once

#include <vector>

#include "reports/picture/image.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// The colours of a deviation map: material left standing is red, cut too deep is blue, the exact
/// surface is nearly white (ColorBrewer's RdBu, safe for colour-blind readers). Each side of zero
/// has its own full scale. Where a side has a gate limit, the limit stands in the middle of that
/// side and the colour jumps there, so that what is in tolerance is pale and what is not is dark.
class DeviationScale {
 public:
  struct Side {
    double limit_mm = 0;  ///< where the colour jumps; half of the full scale without a limit
    double end_mm = 0;    ///< full scale
    bool has_limit = false;
  };

  /// Scaled by the gate limits; a side reaches at least to twice its limit and to what was
  /// measured.
  static DeviationScale for_gate(const verifier::StageDeviation& deviation,
                                 const verifier::GateLimits& limits);
  /// Scaled by what was measured alone, however small; the same on both sides.
  static DeviationScale magnified(const verifier::StageDeviation& deviation);

  const Side& gouge() const { return gouge_; }
  const Side& uncut() const { return uncut_; }
  /// −1 at the full scale of gouge, 0 at zero, 1 at the full scale of uncut; clamped.
  double position(double deviation_mm) const;
  /// The deviation at `position`, the inverse of the above.
  double deviation_mm(double position) const;
  Rgba colour(double deviation_mm) const;
  /// Places that a legend names: both ends, both limits, zero; ascending.
  std::vector<double> ticks_mm() const;

 private:
  DeviationScale(Side gouge, Side uncut) : gouge_(gouge), uncut_(uncut) {}
  Side gouge_, uncut_;
};

}  // namespace limitgauge::reports
