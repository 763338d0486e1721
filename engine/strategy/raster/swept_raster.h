#pragma once

#include <cstdint>
#include <vector>

#include "engine/strategy/raster/isoline.h"

namespace limitgauge::engine::strategy {

/// Pixels that discs moved along straight lines have swept: those whose centres they have covered.
class SweptRaster {
 public:
  /// `swept` holds one flag a pixel.
  SweptRaster(const Raster& raster, std::vector<std::uint8_t> swept)
      : raster_(raster), swept_(std::move(swept)) {}

  void sweep(const FlatPoint& from, const FlatPoint& to, double radius_mm);
  void sweep(const std::vector<FlatPoint>& line, double radius_mm);
  /// Whether every pixel's centre that such a disc covers was swept before.
  bool is_swept(const FlatPoint& from, const FlatPoint& to, double radius_mm) const;

  const std::vector<std::uint8_t>& flags() const { return swept_; }

 private:
  template <class Visit>
  bool visit_rows(const FlatPoint& from, const FlatPoint& to, double radius_mm,
                  const Visit& visit) const;

  Raster raster_;
  std::vector<std::uint8_t> swept_;
};

}  // namespace limitgauge::engine::strategy
