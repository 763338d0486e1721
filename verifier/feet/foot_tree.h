#pragma once

#include <array>
#include <vector>

#include "verifier/feet/foot_cell.h"

namespace limitgauge::verifier {

/// The cells of a surface under a tree of oriented boxes, four children a node. An oriented box is
/// as thin as the sag of what it holds, so that also a query far off visits little beyond the cell
/// of its foot. Boxes are in single precision, four at once in vector registers: each holds its
/// cells with a margin that covers the rounding (see foot_tree.cpp). Queries may be made from any
/// thread.
class FootTree {
 public:
  FootTree() = default;
  explicit FootTree(const SurfaceTree& tree);

  /// Improves `best` to the nearest point of all cells; where none is nearer it stays as it was.
  /// The coordinates of `p` are below 1e12 mm.
  void nearest(const model::Vec3& p, Foot& best) const;
  /// Calls `visit(cell, foot)` for every cell that has a point within `within_mm` of `p`.
  template <class Visit>
  void each_near(const model::Vec3& p, double within_mm, Visit&& visit) const;

  const std::vector<FootCell>& cells() const { return cells_; }
  std::size_t memory_bytes() const {
    return cells_.capacity() * sizeof(FootCell) + nodes_.capacity() * sizeof(Node);
  }

 private:
  static constexpr int kWide = 4;
  static constexpr std::uint32_t kLeaf = 0x80000000U, kNoChild = 0xffffffffU;
  using Lane = std::array<float, kWide>;
  struct alignas(16) Node {
    std::array<Lane, 3> centre{}, half{};
    std::array<std::array<Lane, 3>, 3> axis{};
    std::array<std::uint32_t, kWide> child{kNoChild, kNoChild, kNoChild, kNoChild};
  };
  friend class FootTreeBuilder;
  void search(const model::Vec3& p, Foot& best) const;
  Lane bounds(const Node& node, const std::array<float, 3>& p) const;

  std::vector<FootCell> cells_;
  std::vector<Node> nodes_;
  model::Vec3 origin_;
};

template <class Visit>
void FootTree::each_near(const model::Vec3& p, double within_mm, Visit&& visit) const {
  const model::Vec3 at = p - origin_;
  const std::array<float, 3> q = {static_cast<float>(at.x), static_cast<float>(at.y),
                                  static_cast<float>(at.z)};
  std::vector<std::uint32_t> stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    const Lane bound = bounds(node, q);
    for (int k = 0; k < kWide; ++k) {
      if (node.child[k] == kNoChild || bound[k] > within_mm * within_mm) continue;
      if ((node.child[k] & kLeaf) == 0) {
        stack.push_back(node.child[k]);
        continue;
      }
      const std::uint32_t index = node.child[k] & ~kLeaf;
      Foot foot;
      foot.squared = within_mm * within_mm;
      nearer_in(cells_[index], index, p, foot);
      if (foot.cell != Foot::kNone) visit(cells_[index], foot);
    }
  }
}

}  // namespace limitgauge::verifier
