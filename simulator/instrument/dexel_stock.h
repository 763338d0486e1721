#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "model/base/run_control.h"
#include "model/geometry/interval.h"
#include "model/part/stock.h"
#include "simulator/instrument/dexel_removal.h"

namespace limitgauge::simulator {

/// A second stock model: intervals of material on vertical lines, one in the middle of each of the
/// equal rectangles into which the stock's box is divided. What a straight move of a convex cutter
/// takes from a line is one interval, worked out in closed form or by a convex minimisation, so
/// that the lines are exact but for kDexelRounding_mm. Shares nothing with the level set beyond the
/// values of model, so that the two can be held against each other. Immutable, cheap to
/// copy. The result is the same for any number of threads.
class DexelStock {
 public:
  /// Lines at most `spacing_mm` apart in x and y, the first half a spacing inside the stock's box.
  /// Throws std::invalid_argument for a spacing or a stock that cannot be.
  DexelStock(const model::Stock& raw, double spacing_mm);

  /// Lines in a stock's box with what `standing` says of each, heights ascending and apart: it is
  /// asked from several threads at once. For a stock that is taken over from somewhere else
  /// (dexels_from.h). Throws std::invalid_argument for a spacing that cannot be, Interrupted.
  DexelStock(const model::Box3& box, double spacing_mm,
             const std::function<std::vector<model::Interval>(double x, double y)>& standing,
             const model::RunControl& control);

  struct Cut;
  /// The stock after `pass`, and what each move took. Throws std::invalid_argument for a pass that
  /// lies turned in this stock's frame: lines know upright cutters only. Throws Interrupted.
  Cut cut(const Pass& pass, const model::RunControl& control) const;

  double spacing_mm() const;  ///< the wider of the spacings in x and y
  double volume_mm3() const;  ///< sum of the intervals' lengths times the area of a rectangle
  /// How far volume_mm3() may be off: a quarter of the second differences of the material's length
  /// along x and along y, times the area of a rectangle. A step between two lines makes two of its
  /// height, half of which it may count for too much; a bend makes one, of which it costs an eighth
  /// at most. Does not know of what lies wholly between two lines.
  double volume_error_mm3() const;
  /// Of the material's boundary, from the lengths on neighbouring lines: no less than it is but for
  /// what lies between two lines, and at most the sum of its shadows along the axes.
  double surface_area_mm2() const;
  std::size_t memory_bytes() const;
  int nx() const;
  int ny() const;
  model::Vec3 line_at(int i, int j) const;                    ///< x and y of a line; z is 0
  std::vector<model::Interval> material(int i, int j) const;  ///< heights, mm: ascending, apart

 private:
  struct State;
  explicit DexelStock(std::shared_ptr<const State> state);
  double length(int i, int j) const;
  std::shared_ptr<const State> state_;
};

struct DexelStock::Cut {
  DexelStock stock;
  Removal removal;
};

}  // namespace limitgauge::simulator
