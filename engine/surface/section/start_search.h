#pragma once

#include <span>
#include <vector>

#include "engine/surface/section/grid_tree.h"

namespace limitgauge::engine::surface {

/// Finds where the curves of a family of planes begin in one grid.
///
/// A point of coordinate x is above the first k(x) planes, where k counts the values up to x; the
/// edge between two points is crossed by the planes between their counts. So one look at an edge
/// serves the whole family.
///
/// Curves of line type come in through a side. A ring crosses no side; the outermost points within
/// it on one side of the plane are higher (or lower) than all their neighbours. So the quadtree is
/// descended only where such points are: a ring crosses one of the lines that part a node, or lies
/// within one of its four parts (paper section 5.2).
class StartSearch {
 public:
  StartSearch(const Grid& grid, int axis, const GridTree& tree, std::span<const double> values);
  SectionStarts run();

 private:
  /// A curve of plane `plane` comes in here.
  struct Start {
    int plane = 0;
    GridEntry entry;
  };
  /// Planes [first, last) of the family.
  struct Planes {
    int first = 0, last = 0;
    bool empty() const { return first >= last; }
  };

  int count(const Vec3& p) const;
  /// As count, walking on from the count of a point nearby.
  int count(const Vec3& p, int nearby) const;
  void scan_side(int side);
  void search(int level, int column, int row, Planes planes);
  void scan_leaf(int column, int row, Planes planes);
  /// Edges from (u, v) to the right or upwards, `edges` of them.
  void scan_row(int u, int v, int edges, Planes planes);
  void scan_column(int u, int v, int edges, Planes planes);
  static void add(std::vector<Start>& starts, int below, int above, const GridEntry& entry);
  void gather(std::vector<Start>& starts, std::vector<int>& offsets,
              std::vector<GridEntry>& entries) const;

  const Grid& grid_;
  const GridTree& tree_;
  double Vec3::*coordinate_;
  std::span<const double> values_;
  std::vector<Start> lines_, rings_;
};

}  // namespace limitgauge::engine::surface
