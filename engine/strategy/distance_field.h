#pragma once

#include <cstdint>
#include <vector>

#include "engine/strategy/height_map.h"

namespace limitgauge::engine::strategy {

/// Exact Euclidean distance in mm from every pixel's centre to the nearest centre of a set pixel;
/// infinite where no pixel is set (Meijster, Roerdink and Hesselink 2000, in integers).
std::vector<float> distance_field(const Raster& raster, const std::vector<std::uint8_t>& set);

}  // namespace limitgauge::engine::strategy
