#pragma once

#include "verifier/robust/robust_figures.h"

namespace limitgauge::verifier {

/// The second instrument at the values that figures name: the raw stock cut by the passes as these
/// values make them, and a ray at each figure's place (RobustFigure::voxel_mm). Of a gouge by a
/// shank or a holder, which cut no stock, nothing is read. Throws InstrumentDisagreement where the
/// two do not agree along the ray, or it is longer than the figure allows.
void read_witnesses(RobustDeviation& robust, const RobustScene& scene,
                    const model::Stock& raw_stock, const StockProbe& probe,
                    const model::RunControl& control);

}  // namespace limitgauge::verifier
