#pragma once

#include "verifier/robust/robust_figures.h"

namespace limitgauge::verifier {

/// The second instrument at the values that figures name: the raw stock cut by the passes as these
/// values make them, and a ray at each figure's place (RobustFigure::voxel_mm). Of a gouge by a
/// shank or a holder, which cut no stock, nothing is read. Throws InstrumentDisagreement as
/// read_ray does. A reading may be longer than the figure all the same: along a wall that was cut
/// right beside the ray a run ends for the certificate (EndRule), and for the ray it may not.
void read_witnesses(RobustDeviation& robust, const RobustScene& scene,
                    const model::Stock& raw_stock, const StockProbe& probe,
                    const model::RunControl& control);

}  // namespace limitgauge::verifier
