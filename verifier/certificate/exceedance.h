#pragma once

#include "verifier/certificate/certificate.h"

namespace limitgauge::verifier {

/// A small part of S on which the depth exceeds a threshold.
struct Spot {
  SurfacePlace place;
  double depth_mm = 0;   ///< at the middle
  double area_mm2 = 0;   ///< of the cell; 0 of a sharp edge
  double radius_mm = 0;  ///< every point of the cell is this near to the middle
  BodyRef body;          ///< that swept it, or is nearest to it
};

/// Where S is gouged, left uncut within reach, or not covered by raw stock, deeper than a
/// threshold.
struct Exceedance {
  std::vector<Spot> spots;  ///< in a fixed order, whatever the number of threads
  /// Every place deeper than threshold + slack lies in a spot, is narrower than 0.02 mm, or lies
  /// (uncut) within 0.01 mm of a place that was not proven to be in reach.
  bool complete = true;
};

struct ExceedanceRequest {
  Side side = Side::gouge;
  double allowance_mm = 0;
  double threshold_mm = 0;
  double slack_mm = 0;           ///< > 0
  double spot_radius_mm = 0.03;  ///< spots are no larger where the depth varies about the threshold
  std::size_t largest_cell_count = 2'000'000;
};

/// Divides the cells whose bounds exceed the threshold until each part is below it (plus slack), or
/// a spot whose middle is above it: a small one, or one whose corners are above it, too. `reach` is
/// asked for uncut only.
Exceedance find_exceedance(const SurfaceCells& cells, const RemovedSpace& space,
                           const ReachQuery* reach, const ExceedanceRequest& request,
                           const model::RunControl& control);

}  // namespace limitgauge::verifier
