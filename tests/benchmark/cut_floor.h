#pragma once

#include <cstddef>
#include <span>

#include "model/base/run_control.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::benchmarks {

/// Voxels of a stock's narrow band.
std::size_t band_voxels(const simulator::StockModel& stock);

/// What a cut must do at the very least: the distance to one ball move, in closed form and in
/// double precision, at as many places as `out` holds, written there. In columns of eight voxels,
/// in as wide registers as the kernel's, on all threads.
void write_distances(double radius_mm, double voxel_mm, const model::RunControl& control,
                     std::span<float> out);

/// The bare cost of one distance evaluation and one write for each of as many voxels as `out`
/// holds: one call of simulator::swept_distance for a move of the pass at a place beside it, on all
/// threads. Moves and places are worked out as they come, 64 places a move.
void write_swept_distances(const simulator::Pass& pass, double voxel_mm,
                           const model::RunControl& control, std::span<float> out);

}  // namespace limitgauge::benchmarks
