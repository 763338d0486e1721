#pragma once

#include "verifier/certificate.h"
#include "verifier/verify.h"

namespace limitgauge::verifier {

/// The voxel instrument (actual → nominal): what the points of the simulated stock say.
struct VoxelFigures {
  /// Deepest foot beyond the stock's tangent plane: the depth of a point under the allowance
  /// surface, times the cosine between S and the stock there.
  double gouge_mm = 0;
  double uncut_mm = 0;  ///< highest point over it, where the surface can be touched
  double largest_error_mm = 0;
};

/// Reads every stock point within sight of S (kStockSight_mm, or more where more is certified): the
/// foot of its perpendicular on S, and how far above the allowance surface it stands. A point whose
/// air side faces away from S says nothing of S; beyond what is certified a point counts only where
/// there is nothing but material (or nothing but air) between it and S. Each point must lie on the
/// surface that the analytic instrument computes for the cut stock; each certified leftover must
/// have stock points where it says, and a certified gouge none: otherwise InstrumentDisagreement
/// with both readings.
VoxelFigures read_stock(const SurfaceCells& cells, const RemovedSpace& space,
                        const ReachQuery& reach, const Certificate& certificate,
                        std::span<const StockReading> readings, const StageCheck& check,
                        const model::RunControl& control);

}  // namespace limitgauge::verifier
