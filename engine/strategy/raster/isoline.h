#pragma once

#include <vector>

#include "engine/strategy/raster/height_map.h"
#include "model/geometry/vec2.h"

namespace limitgauge::engine::strategy {

/// A point of the XY plane, mm.
using FlatPoint = model::Vec2;

/// A curve along which a field has one value; open ones end at the window's border.
struct Isoline {
  std::vector<FlatPoint> points;  ///< of a closed one the first is repeated at the end
  bool closed = false;
};

/// The isolines of `field` at `value` inside `window`, by marching squares with linear
/// interpolation; higher values lie on the left.
std::vector<Isoline> isolines(const Raster& raster, const std::vector<float>& field,
                              const Window& window, double value);

}  // namespace limitgauge::engine::strategy
