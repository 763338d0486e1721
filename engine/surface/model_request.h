#pragma once

namespace limitgauge::engine::surface {

/// What the finish model is built for.
struct ModelRequest {
  double precision_mm = 0.01;    ///< bound on the chord error of the limit mesh
  double largest_offset_mm = 0;  ///< largest normal offset asked of it later (cutter + allowance)
  int largest_depth = 10;
};

}  // namespace limitgauge::engine::surface
