#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "verifier/cells/surface_cells.h"

namespace limitgauge::verifier {

/// An axis-parallel rectangle of parameters, closed.
struct ParameterRect {
  double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
  bool holds(const ParameterRect& r) const {
    return u0 <= r.u0 && r.u1 <= u1 && v0 <= r.v0 && r.v1 <= v1;
  }
  bool touches(const ParameterRect& r) const {
    return u0 <= r.u1 && r.u0 <= u1 && v0 <= r.v1 && r.v0 <= v1;
  }
};
/// Of a SurfaceCell or a CellPart.
template <class Cell>
ParameterRect rect_of(const Cell& cell) {
  return {cell.u, cell.u + cell.size_u, cell.v, cell.v + cell.size_v};
}

/// What a cell is found by, a tenth of its size.
struct IndexedCell {
  int patch = 0;
  bool is_point = false;  ///< of an irregular vertex
  ParameterRect rect;
};
IndexedCell indexed(const SurfaceCell& cell);

/// Finds the cells of a patch by their parameters. The cells come from halving, so that every patch
/// falls apart along middle lines: a binary tree a patch.
class ParameterIndex {
 public:
  /// Points (cells of irregular vertices) are left out; results are indices into `cells`.
  explicit ParameterIndex(std::span<const SurfaceCell> cells);
  explicit ParameterIndex(std::span<const IndexedCell> cells);

  int patch_count() const { return static_cast<int>(roots_.size()); }
  /// A cell that holds the parameters; none beside an irregular vertex, where a point stands for
  /// the surface.
  std::optional<std::uint32_t> find(int patch, double u, double v) const;
  /// Calls `see(index)` for each cell of the patch that overlaps `rect` or touches it.
  template <class See>
  void overlapping(int patch, const ParameterRect& rect, See&& see) const {
    overlapping_beyond(patch, rect, std::nullopt, see);
  }
  /// The same without those for which a call with `inner` has done so.
  template <class See>
  void overlapping_beyond(int patch, const ParameterRect& rect,
                          const std::optional<ParameterRect>& inner, See&& see) const {
    if (patch >= 0 && patch < patch_count() && roots_[patch] >= 0)
      visit(roots_[patch], {0, 1, 0, 1}, rect, inner, see);
  }

 private:
  struct Node {
    std::int32_t low = -1, high = -1;  ///< children; negative in a leaf
    bool in_u = true;                  ///< split at the middle of u, else of v
    std::uint32_t first = 0, count = 0;
  };
  std::int32_t build(std::span<const IndexedCell> cells, std::vector<std::uint32_t> list,
                     const ParameterRect& region);
  static ParameterRect half(const ParameterRect& r, bool in_u, bool high);

  template <class See>
  void visit(std::int32_t at, const ParameterRect& region, const ParameterRect& rect,
             const std::optional<ParameterRect>& inner, See&& see) const {
    if (!region.touches(rect) || (inner && inner->holds(region))) return;
    const Node& node = nodes_[at];
    if (node.count > 0 && !(inner && region.touches(*inner)))
      for (std::uint32_t k = 0; k < node.count; ++k) see(order_[node.first + k]);
    if (node.low >= 0) visit(node.low, half(region, node.in_u, false), rect, inner, see);
    if (node.high >= 0) visit(node.high, half(region, node.in_u, true), rect, inner, see);
  }

  std::vector<std::int32_t> roots_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace limitgauge::verifier
