#pragma once

#include <cstddef>
#include <span>

#include "engine/model/run_control.h"
#include "simulator/stock_model.h"

namespace limitgauge::benchmarks {

/// Voxels of a stock's narrow band.
std::size_t band_voxels(const simulator::StockModel& stock);

/// The least that any cut must do: the distance to one ball move, in closed form and in double
/// precision, at as many places as `out` holds, written there. In columns of eight voxels, in as
/// wide registers as the kernel's, on all threads.
void write_distances(double radius_mm, double voxel_mm, const model::RunControl& control,
                     std::span<float> out);

}  // namespace limitgauge::benchmarks
