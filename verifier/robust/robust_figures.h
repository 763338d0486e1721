#pragma once

#include <span>

#include "model/base/run_control.h"
#include "verifier/certificate/certificate.h"
#include "verifier/gate/verify.h"
#include "verifier/robust/tolerance_box.h"

namespace limitgauge::verifier {

/// What a figure over tolerances is certified in.
struct RobustScene {
  const SurfaceCells& cells;
  const RemovedSpace& raw;
  std::span<const Pass> passes;
  const StageCheck& check;
  const CertificateRequest& request;
  double highest_mm = 0;  ///< shanks and holders that stay above it are left out
  /// What is left out of a leftover: what all cutters of the tolerances, or those that leave most,
  /// are proven not to touch (ToleratedReach). Null: nothing.
  const ReachQuery* reach_of_any = nullptr;
  const ReachQuery* reach_of_extreme = nullptr;
};

/// One figure for every value of the stated tolerances. Throws as ToleranceBox does, Interrupted.
RobustFigure robust_figure(const RobustScene& scene, Side side, const model::Tolerances& tolerances,
                           const model::RunControl& control);

/// The figures of a stage, each with the margin of its limit, where it has one and margins are
/// asked for. `nominal` has the figures without tolerances.
RobustDeviation robust_deviation(const RobustScene& scene, const StageDeviation& nominal,
                                 const model::RunControl& control);

}  // namespace limitgauge::verifier
