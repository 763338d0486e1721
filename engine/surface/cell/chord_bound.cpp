#include "engine/surface/cell/chord_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/surface/cell/cell_grid.h"
#include "engine/surface/cell/vertex_zone.h"

namespace limitgauge::engine::surface {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// Depth from which bounds are looked at: fewer cells are all corners.
constexpr int kFirstDepth = 2;
/// Depth at which the cells at corners are patches of their own.
constexpr int kZoneStart = 1;

/// Bounds of all cells but `width`² at extraordinary corners, for this depth and deeper ones.
class GridBounds {
 public:
  GridBounds(const CellGrid& grid, int width) {
    for (int v = 0; v < grid.cells(); ++v)
      for (int u = 0; u < grid.cells(); ++u) {
        if (grid.at_extraordinary(u, v, width)) continue;
        cells_.push_back(grid.bound(u, v));
        if (grid.meets(u, v)) meeting_.push_back(cells_.back());
      }
    for (int side = 0; side < 4; ++side) sides_[side] = grid.side_bound_but(side, width);
  }
  MeshError at(double scale) const {
    MeshError error;
    for (const MeshBound& cell : cells_) error.own_mm = std::max(error.own_mm, cell.at(scale));
    for (const MeshBound& cell : meeting_)
      error.meeting = worse(error.meeting, cell.meeting(scale));
    for (int side = 0; side < 4; ++side)
      error.sides[side] = {sides_[side].along * scale, sides_[side].across * scale, 0};
    return error;
  }

 private:
  std::vector<MeshBound> cells_, meeting_;
  std::array<SplitBound, 4> sides_{};
};

MeshError unproven() {
  const SplitBound side{kUnbounded, kUnbounded, 0};
  return {kUnbounded, kUnbounded, kUnbounded, {0, kUnbounded, 0}, {side, side, side, side}};
}

void widen(MeshError& error, const ZoneBound& zone) {
  error.corner_mm = std::max(error.corner_mm, zone.surface);
  error.meeting = worse(error.meeting, zone.meeting);
  error.corner_side_mm = std::max(error.corner_side_mm, zone.side.along);
}

double scale_of(int levels) {
  return std::ldexp(1.0, -2 * levels);
}

class PatchBounds {
 public:
  explicit PatchBounds(const BoundRequest& request, ChordBounds known = {})
      : request_(request), offset_mm_(request.offset_mm), bounds_(std::move(known)) {
    bounds_.at.resize(static_cast<std::size_t>(request.largest_depth) + 1,
                      {unproven(), unproven()});
  }

  ChordBounds of(CellPatch patch) {
    const int first = std::max(kFirstDepth, patch.smallest_limit_depth());
    const int start = std::max(kZoneStart, patch.smallest_limit_depth());
    while (patch.depth() < start) patch.refine();
    bool any = false;
    for (int c = 0; c < 4; ++c) any |= bounds_.extraordinary[c] = !patch.ring(c).regular();
    // Corners must be two cells wide before the offset has bounds, and rings about them begin four
    // levels below the corners' own.
    const int last = std::min(
        std::max(request_.analysed_depth, any ? std::max(first + 1, start + 3) : first), largest());
    std::vector<VertexZones> zones;
    for (int c = 0; c < 4; ++c)
      if (bounds_.extraordinary[c] && request_.limit)
        zones.emplace_back(patch.corner_cell(c), start, last, largest(), zone_rim(c));
    bounds_.corner_depth = first;
    while (patch.depth() < first) patch.refine();
    for (int depth = first; depth <= last; ++depth) {
      if (depth > first) patch.refine();
      analyse(patch, depth == last ? largest() : depth);
      if (zones.empty() && depth < last && is_enough(depth)) return up_to(depth);
    }
    for (const VertexZones& zone : zones)
      for (int depth = first; depth <= largest(); ++depth) add_zone(zone, depth);
    return std::move(bounds_);
  }

  /// Of a patch without extraordinary corners, of which those up to `known` are there.
  ChordBounds next(CellPatch patch, int known) {
    const int first = std::max(kFirstDepth, patch.smallest_limit_depth());
    const int last = std::min(std::max(request_.analysed_depth, first), largest());
    while (patch.depth() <= known) patch.refine();
    analyse(patch, patch.depth() == last ? largest() : patch.depth());
    return patch.depth() == last ? std::move(bounds_) : up_to(patch.depth());
  }

 private:
  int largest() const { return static_cast<int>(bounds_.at.size()) - 1; }
  bool is_enough(int depth) const {
    return depth >= request_.least_depth &&
           bounds_.at[static_cast<std::size_t>(depth)].largest_mm() <= request_.enough_mm;
  }
  ChordBounds up_to(int depth) {
    bounds_.at.resize(static_cast<std::size_t>(depth) + 1);
    bounds_.at.shrink_to_fit();
    return std::move(bounds_);
  }

  void analyse(const CellPatch& patch, int deepest) {
    const GridBounds limit(CellGrid(patch, 0, request_.rim), VertexZones::kWidth);
    const int hole = patch.cells() >> bounds_.corner_depth;
    const bool holed = std::any_of(bounds_.extraordinary.begin(), bounds_.extraordinary.end(),
                                   [](bool e) { return e; });
    std::optional<GridBounds> offset;
    if (offset_mm_ > 0 && !(holed && hole < 2))
      offset.emplace(CellGrid(patch, offset_mm_, request_.rim), hole);
    for (int depth = patch.depth(); depth <= deepest; ++depth) {
      const double scale = scale_of(depth - patch.depth());
      ChordBound& b = bounds_.at[static_cast<std::size_t>(depth)];
      b.limit = limit.at(scale);
      b.offset = offset ? offset->at(scale) : offset_mm_ > 0 ? unproven() : b.limit;
      if (offset_mm_ > 0) b.offset.corner_mm = 0;
    }
  }

  void add_zone(const VertexZones& zone, int depth) {
    ChordBound& b = bounds_.at[static_cast<std::size_t>(depth)];
    const ZoneBound bound = zone.at(depth);
    widen(b.limit, bound);
    if (offset_mm_ <= 0) widen(b.offset, bound);
  }

  /// The rims of a patch turned so that corner `c` is its first.
  std::array<bool, 4> zone_rim(int c) const {
    std::array<bool, 4> turned{};
    for (int side = 0; side < 4; ++side) turned[side] = request_.rim[(c + side) % 4];
    return turned;
  }

  BoundRequest request_;
  double offset_mm_;
  ChordBounds bounds_;
};

}  // namespace

ChordBounds chord_bounds(CellPatch patch, const BoundRequest& request) {
  return PatchBounds(request).of(std::move(patch));
}

void add_next_depth(ChordBounds& bounds, CellPatch patch, const BoundRequest& request) {
  const int known = static_cast<int>(bounds.at.size()) - 1;
  bounds = PatchBounds(request, std::move(bounds)).next(std::move(patch), known);
}

}  // namespace limitgauge::engine::surface
