#pragma once

#include "engine/model/stock.h"

namespace limitgauge::simulator {

/// Signed distance to the raw stock, negative inside, and its gradient.
struct RawSample {
  double distance = 0;
  model::Vec3 gradient;
};

/// Exact signed distance from `p` to the block or bar.
RawSample raw_distance(const model::Stock& stock, const model::Vec3& p);
double surface_area_mm2(const model::Stock& stock);

}  // namespace limitgauge::simulator
