#pragma once

#include <vector>

#include "simulator/grid/stock_grid.h"
#include "simulator/sweep/swept_distance.h"

namespace limitgauge::simulator {

/// Says quickly that a body passes above everything that stands: a pyramid of the highest material
/// over square columns.
class ClearanceMap {
 public:
  explicit ClearanceMap(const ColumnTops& tops);

  /// True where no point within `margin_mm` of the body, swept along `move`, is as low as material
  /// may stand. False says nothing.
  bool clears(const CutterProfile& body, const SweptMove& move, double margin_mm = 0) const;
  double highest() const { return levels_.back().top.front(); }

 private:
  struct Level {
    int nx = 0, ny = 0;
    double edge = 0;
    std::vector<double> top;
  };
  bool clears(std::size_t level, int i, int j, const CutterProfile& body, const SweptMove& move,
              double margin_mm) const;

  model::Vec3 corner_;
  std::vector<Level> levels_;  // the finest first, the last one a single column
};

}  // namespace limitgauge::simulator
