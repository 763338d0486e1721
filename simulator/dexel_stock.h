#pragma once

#include <memory>
#include <vector>

#include "engine/model/run_control.h"
#include "engine/model/stock.h"
#include "simulator/pass.h"

namespace limitgauge::simulator {

/// What one move took away, from columns of material along Z.
struct MoveRemoval {
  double volume_mm3 = 0;
  double rate_mm3_min = 0;  ///< volume over the move's time at its feed rate; 0 where it has none
  /// Largest height of material removed in one column (axial engagement).
  double axial_mm = 0;
  /// Width, level and across the move's direction, over which material was removed (radial
  /// engagement); of a vertical move the largest width.
  double radial_mm = 0;
};

/// Totals of one pass.
struct RemovalTotals {
  double volume_mm3 = 0;
  double largest_rate_mm3_min = 0;
  std::size_t largest_rate_move = 0;
  double largest_axial_mm = 0, largest_radial_mm = 0;
  /// Feed moves that removed nothing.
  double air_length_mm = 0, air_time_s = 0;
  double spacing_mm = 0;  ///< of the columns
};

struct Removal {
  std::vector<MoveRemoval> moves;  ///< one a move of the path
  RemovalTotals totals;
};

/// A second stock model: intervals of material on vertical lines on a square grid. What a straight
/// move of a convex cutter takes from a line is an interval with closed or convex ends, so that the
/// lines are exact. Immutable, cheap to copy. The result is the same for any number of threads.
class DexelStock {
 public:
  /// Lines `spacing_mm` apart in x and y, the first half a spacing inside the stock's box.
  DexelStock(const model::Stock& raw, double spacing_mm);

  struct Cut;
  /// The stock after `pass`, and what each move took.
  Cut cut(const Pass& pass, const model::RunControl& control) const;

  struct Interval {
    double low_mm, high_mm;
  };
  double spacing_mm() const;
  double volume_mm3() const;  ///< sum of the intervals' lengths times the squared spacing
  std::size_t memory_bytes() const;
  int nx() const;
  int ny() const;
  model::Vec3 line_at(int i, int j) const;  ///< x and y of a line; z is 0
  std::vector<Interval> material(int i, int j) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

struct DexelStock::Cut {
  DexelStock stock;
  Removal removal;
};

}  // namespace limitgauge::simulator
