#pragma once

#include <numbers>

namespace limitgauge::model {

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

}  // namespace limitgauge::model
