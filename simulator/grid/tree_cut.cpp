#include "simulator/grid/tree_cut.h"

#include "simulator/grid/block_changes.h"
#include "simulator/grid/leaf_values.h"

namespace limitgauge::simulator::vdb {
namespace {

bool stands(const Tree& tree, const Coord& leaf) {
  return tree.probeConstLeaf(leaf) != nullptr || tree.getValue(leaf) < 0;
}

// Leaves that stand already are written in place, the rest is noted.
class Cut : public LeafSink {
 public:
  explicit Cut(Tree& tree) : tree_(tree) {}

  bool wanted(const Index3& corner) const override { return stands(tree_, coord(corner)); }
  void removed(const Index3& corner, int edge) override {
    each_cube(cube_at(corner, edge), kLeafEdge, [&](const Index3& c) {
      if (wanted(c)) changes_.emptied.push_back(coord(c));
    });
  }
  void reached(const Index3& corner, const LeafDistances& distances) override {
    const Coord at = coord(corner);
    if (Leaf* leaf = tree_.probeLeaf(at)) return lower(*leaf, distances);
    // Wholly inside so far: a leaf is made only where something changes and something stands.
    const float band = tree_.background();
    const auto [least, most] = value_range(distances);
    if (least == band) return;
    if (most == -band) return changes_.emptied.push_back(at);
    auto leaf = std::make_unique<Leaf>(at, -band, false);
    lower(*leaf, distances);
    changes_.leaves.push_back(std::move(leaf));
  }
  BlockChanges take() { return std::move(changes_); }

 private:
  void lower(Leaf& leaf, const LeafDistances& distances) {
    const float band = tree_.background();
    const LoweredLeaf lowered = lower_values(distances, leaf.buffer().data());
    if (!lowered.changed) return;
    if (lowered.least == band) return changes_.emptied.push_back(leaf.origin());
    mark_band(leaf, band);
  }

  Tree& tree_;
  BlockChanges changes_;
};

bool stands_in_block(const Tree& tree, const Index3& corner) {
  bool any = false;
  each_cube(cube_at(corner, kBlockEdge), kLeafEdge,
            [&](const Index3& c) { any = any || stands(tree, coord(c)); });
  return any;
}

}  // namespace

void cut_tree(Tree& tree, const SweepIndex& pass, const Lattice& lattice, const PassReach& reach,
              const model::RunControl& control) {
  for (const Index3& node : reach.swallowed_nodes)
    tree.addTile(2, coord(node), tree.background(), false);
  for (const Index3& block : reach.swallowed_blocks) {
    Cut cut(tree);
    cut.removed(block, kBlockEdge);
    cut.take().put_into(tree);
  }
  const double band = tree.background();
  change_blocks(tree, reach.partly.size(), control, [&] {
    auto cutter = std::make_shared<BlockCutter>(pass, lattice, band);
    return [&, cutter](std::size_t i) {
      Cut cut(tree);
      if (stands_in_block(tree, reach.partly[i])) cutter->cut(reach.partly[i], cut);
      return cut.take();
    };
  });
}

}  // namespace limitgauge::simulator::vdb
