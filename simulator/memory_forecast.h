#pragma once

#include <cstddef>

namespace limitgauge::simulator {

/// Bytes of a narrow band about a surface of this area at this voxel.
double band_bytes(double area_mm2, double voxel_mm);
/// Throws ResourceError, naming a voxel that would do, when `forecast_bytes` exceeds the limit.
void require_memory(double forecast_bytes, std::size_t limit_bytes, double voxel_mm);

}  // namespace limitgauge::simulator
