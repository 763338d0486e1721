#include "engine/strategy/rows/drive_rows.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::engine::strategy {

std::vector<double> even_places(double low_mm, double high_mm, double step_mm) {
  const double width = high_mm - low_mm;
  constexpr double kSpareShare = 0.1;  // of a step: the mesh is a little smaller than the surface
  const int count = std::max(1, static_cast<int>(std::floor(width / step_mm + kSpareShare)));
  const double first = low_mm + (width - (count - 1) * step_mm) / 2;
  std::vector<double> places;
  for (int i = 0; i < count; ++i) places.push_back(first + i * step_mm);
  return places;
}

}  // namespace limitgauge::engine::strategy
