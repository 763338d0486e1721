#pragma once

#include "engine/model/stock.h"
#include "engine/strategy/isoline.h"

namespace limitgauge::engine::strategy {

/// The raw stock seen from above.
class StockOutline {
 public:
  explicit StockOutline(const model::Stock& stock) : stock_(stock) {}

  /// From the outline, mm; negative inside.
  double distance_mm(const FlatPoint& p) const;
  /// Unit direction of the shortest way out of the stock.
  FlatPoint outward(const FlatPoint& p) const;

 private:
  model::Stock stock_;
};

}  // namespace limitgauge::engine::strategy
