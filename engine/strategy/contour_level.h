#pragma once

#include <vector>

#include "engine/strategy/clearing_field.h"
#include "engine/strategy/isoline.h"

namespace limitgauge::engine::strategy {

/// What the loops of one level are made with; lengths mm.
struct LoopRule {
  Window window;  ///< of the raster: the stock grown by the cutter and a little
  double step_over_mm = 0;
  double reduction_mm = 0;  ///< largest distance of a point left out
  double slack_mm = 0;      ///< of links: interpolation between samples
};

/// The loops of one level, grouped by distance from the forbidden region, outermost group first.
class ContourLevel {
 public:
  ContourLevel(const Raster& raster, const LevelField& field, const LoopRule& rule);

  const std::vector<std::vector<Isoline>>& groups() const { return groups_; }
  /// Whether the straight way from `a` to `b` keeps clear of the forbidden region.
  bool clear_between(const FlatPoint& a, const FlatPoint& b) const;

 private:
  double clear_at(const FlatPoint& p) const;

  Raster raster_;
  std::vector<float> clear_mm_;  ///< of the window only
  Window window_;
  double slack_mm_ = 0;
  std::vector<std::vector<Isoline>> groups_;
};

}  // namespace limitgauge::engine::strategy
