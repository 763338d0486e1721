#pragma once

#include "engine/strategy/raster/isoline.h"
#include "model/part/stock.h"

namespace limitgauge::engine::strategy {

/// The raw stock seen from above; of a mesh or what leans, the box about it: a path that clears the
/// box clears the stock.
class StockOutline {
 public:
  explicit StockOutline(const model::Stock& stock);

  /// From the outline, mm; negative inside.
  double distance_mm(const FlatPoint& p) const;
  /// Unit direction of the shortest way out of the stock.
  FlatPoint outward(const FlatPoint& p) const;

 private:
  model::Stock stock_;
};

}  // namespace limitgauge::engine::strategy
