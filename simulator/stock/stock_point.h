#pragma once

#include "model/geometry/vec3.h"

namespace limitgauge::simulator {

/// A point of the stock's surface that has been moved onto the exact surface it belongs to (a swept
/// move or a face of the raw stock).
struct StockPoint {
  model::Vec3 position;
  double residual_mm = 0;  ///< |exact level set| there after projection; a bound on its error
};

}  // namespace limitgauge::simulator
