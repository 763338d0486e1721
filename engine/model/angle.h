#pragma once

#include <array>
#include <numbers>

namespace limitgauge::model {

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// Cosine and sine, exact at quarter turns where std::cos would leave 6e-17.
std::array<double, 2> direction(double angle_deg);

}  // namespace limitgauge::model
