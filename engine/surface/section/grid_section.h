#pragma once

#include <span>

#include "engine/surface/section/grid_tree.h"

namespace limitgauge::engine::surface {

/// A grid and a quadtree of coordinate ranges along one axis: the paper's section 5 for one patch.
class GridSection {
 public:
  GridSection(Grid grid, int axis);

  const Grid& grid() const { return grid_; }
  double low() const { return tree_.whole().low; }
  double high() const { return tree_.whole().high; }

  /// Sections 5.1 and 5.2 of the paper for a whole family of planes in one pass: the sides of the
  /// grid for curves of line type, the quadtree for rings. `values` ascend.
  SectionStarts starts(std::span<const double> values) const;
  /// Sections 5.3 and 5.4: appends the curves of plane number `plane` of the family, at `value`:
  /// first those of line type, then rings.
  void trace(const SectionStarts& starts, std::size_t plane, double value, SectionScratch& scratch,
             std::vector<SectionChain>& chains) const;
  /// The curves of one plane.
  void cut(double value, SectionScratch& scratch, std::vector<SectionChain>& chains) const;

 private:
  Grid grid_;
  int axis_;
  GridTree tree_;
};

}  // namespace limitgauge::engine::surface
