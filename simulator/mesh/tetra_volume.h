#pragma once

#include <array>

namespace limitgauge::simulator {

/// Share of a unit cube where the field is negative, the field being linear in each of the six
/// tetrahedra about the cube's main diagonal. Corner k of the cube is at (k>>2 & 1, k>>1 & 1, k &
/// 1). Exact for a linear field, of second order in the cube's edge for a smooth one.
double negative_share(const std::array<double, 8>& corner_values);

}  // namespace limitgauge::simulator
