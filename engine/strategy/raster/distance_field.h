#pragma once

#include <cstdint>
#include <vector>

#include "engine/strategy/raster/height_map.h"

namespace limitgauge::engine::strategy {

/// Exact Euclidean distance in mm from every pixel's centre to the nearest centre of a set pixel;
/// infinite where no pixel is set (Meijster, Roerdink and Hesselink 2000, in integers).
std::vector<float> distance_field(const Raster& raster, const std::vector<std::uint8_t>& set);

/// The same up to a reach only, over and over for one raster: pixels farther than that are said to
/// be at the reach. Cost grows with the set's border, not with its area. For one thread.
class NearDistances {
 public:
  NearDistances(const Raster& raster, double reach_mm);

  /// Distances to the pixels of the raster for which `heights` (rows `stride` apart) exceed `z`.
  /// Valid until the next call.
  const std::vector<float>& to_above(const float* heights, int stride, double z);

 private:
  struct Apex {
    int column = 0, from = 0;
    std::int64_t height2 = 0;  ///< squared distance in its own column
  };
  void measure_columns(const float* heights, int stride, double z);
  void measure_row(const std::uint16_t* g, float* distance);
  void insert(int column, std::int64_t height2);

  Raster raster_;
  std::uint16_t reach_;  ///< in pixels, rounded up
  float reach_mm_;
  std::vector<std::uint16_t> in_column_;
  std::vector<Apex> apexes_;
  std::vector<float> distance_;
};

}  // namespace limitgauge::engine::strategy
