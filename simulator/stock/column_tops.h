#pragma once

#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::simulator {

/// How high material may stand over the square columns of a regular grid in x and y.
struct ColumnTops {
  model::Vec3 corner_mm;  ///< lower corner of the first column; z is of no account
  double edge_mm = 0;
  int nx = 0, ny = 0;
  std::vector<double> top_mm;  ///< x fastest; minus infinity where nothing stands
};

}  // namespace limitgauge::simulator
