#include "engine/surface/chord_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/surface/cell_grid.h"
#include "engine/surface/vertex_zone.h"

namespace limitgauge::engine::surface {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Depth from which bounds are looked at: fewer cells are all corners.
constexpr int kFirstDepth = 2;
/// Depth at which the cells at corners are patches of their own.
constexpr int kZoneStart = 1;

/// Bounds of all cells but `width`² at extraordinary corners, for this depth and deeper ones.
class GridBounds {
 public:
  GridBounds(const CellGrid& grid, int width) {
    for (int v = 0; v < grid.cells(); ++v)
      for (int u = 0; u < grid.cells(); ++u)
        if (!grid.at_extraordinary(u, v, width)) cells_.push_back(grid.bound(u, v));
    for (int side = 0; side < 4; ++side) side_[side] = grid.side_bound_but(side, width);
  }
  double at(double scale) const {
    double largest = 0;
    for (const MeshBound& cell : cells_) largest = std::max(largest, cell.at(scale));
    return largest;
  }
  double side(int side, double scale) const { return side_[side] * scale; }

 private:
  std::vector<MeshBound> cells_;
  std::array<double, 4> side_{};
};

double scale_of(int levels) {
  return std::ldexp(1.0, -2 * levels);
}

class PatchBounds {
 public:
  explicit PatchBounds(const BoundRequest& request)
      : request_(request), offset_mm_(request.offset_mm) {
    ChordBound none{kInfinity, kInfinity, {kInfinity, kInfinity, kInfinity, kInfinity}};
    bounds_.at.assign(static_cast<std::size_t>(request.largest_depth) + 1, none);
  }

  ChordBounds of(CellPatch patch) {
    const int first = std::max(kFirstDepth, patch.smallest_limit_depth());
    const int start = std::max(kZoneStart, patch.smallest_limit_depth());
    while (patch.depth() < start) patch.refine();
    bool any = false;
    for (int c = 0; c < 4; ++c) any |= bounds_.extraordinary[c] = !patch.ring(c).regular();
    // Cells at extraordinary corners must be two cells wide before the offset has bounds.
    const int last =
        std::min(std::max(request_.analysed_depth, any ? first + 1 : first), largest());
    std::vector<VertexZones> zones;
    for (int c = 0; c < 4; ++c)
      if (bounds_.extraordinary[c] && request_.limit)
        zones.emplace_back(patch.corner_cell(c), start, last, largest());
    bounds_.corner_depth = first;
    while (patch.depth() < first) patch.refine();
    for (int depth = first; depth <= last; ++depth) {
      if (depth > first) patch.refine();
      analyse(patch, depth == last ? largest() : depth);
    }
    for (const VertexZones& zone : zones)
      for (int depth = first; depth <= largest(); ++depth) add_zone(zone, depth);
    return std::move(bounds_);
  }

 private:
  int largest() const { return static_cast<int>(bounds_.at.size()) - 1; }

  void analyse(const CellPatch& patch, int deepest) {
    const CellGrid limit(patch, 0);
    const GridBounds limit_bound(limit, VertexZones::kWidth);
    const int hole = patch.cells() >> bounds_.corner_depth;
    const bool holed = std::any_of(bounds_.extraordinary.begin(), bounds_.extraordinary.end(),
                                   [](bool e) { return e; });
    std::optional<GridBounds> offset_bound;
    if (offset_mm_ > 0 && !(holed && hole < 2))
      offset_bound.emplace(CellGrid(patch, offset_mm_), hole);
    for (int depth = patch.depth(); depth <= deepest; ++depth) {
      const double scale = scale_of(depth - patch.depth());
      ChordBound& b = bounds_.at[static_cast<std::size_t>(depth)];
      b.limit_mm = limit_bound.at(scale);
      b.offset_mm = offset_mm_ > 0 ? offset_bound ? offset_bound->at(scale) : kInfinity
                                   : limit_bound.at(scale);
      for (int side = 0; side < 4; ++side) {
        b.side_mm[side] = limit_bound.side(side, scale);
        if (offset_mm_ <= 0) continue;
        const double moved = offset_bound ? offset_bound->side(side, scale) : kInfinity;
        b.side_mm[side] = std::max(b.side_mm[side], moved);
      }
    }
  }

  void add_zone(const VertexZones& zone, int depth) {
    ChordBound& b = bounds_.at[static_cast<std::size_t>(depth)];
    const ZoneBound zone_mm = zone.at(depth);
    b.limit_mm = std::max(b.limit_mm, zone_mm.surface);
    if (offset_mm_ <= 0) b.offset_mm = std::max(b.offset_mm, zone_mm.surface);
    for (double& side : b.side_mm) side = std::max(side, zone_mm.side);
  }

  BoundRequest request_;
  double offset_mm_;
  ChordBounds bounds_;
};

}  // namespace

ChordBounds chord_bounds(CellPatch patch, const BoundRequest& request) {
  return PatchBounds(request).of(std::move(patch));
}

}  // namespace limitgauge::engine::surface
