#pragma once

#include "engine/strategy/raster/clearing_field.h"
#include "engine/strategy/raster/isoline.h"

namespace limitgauge::engine::strategy {

/// Where the tip may be at one level: known on a coarse raster everywhere, on a fine one near the
/// border of the forbidden region.
class LevelSpace {
 public:
  LevelSpace(const Raster& raster, LevelField everywhere, NearField near)
      : raster_(raster), everywhere_(std::move(everywhere)), near_(std::move(near)) {}

  bool anything_forbidden() const { return everywhere_.anything_forbidden; }
  const Raster& raster() const { return raster_; }
  const std::vector<float>& clear_mm() const { return everywhere_.clear_mm; }
  const NearField& near() const { return near_; }

  /// A place's distance from the forbidden region, at least; mm.
  double clear_at(const FlatPoint& p) const;
  /// Whether the straight way from `a` to `b` keeps clear of it.
  bool clear_between(const FlatPoint& a, const FlatPoint& b) const;

 private:
  Raster raster_;
  LevelField everywhere_;
  NearField near_;
};

}  // namespace limitgauge::engine::strategy
