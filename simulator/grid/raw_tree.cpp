#include "simulator/grid/raw_tree.h"

#include <algorithm>

#include "simulator/grid/block_changes.h"
#include "simulator/stock/raw_stock.h"

namespace limitgauge::simulator::vdb {
namespace {

class RawBlock {
 public:
  RawBlock(const RawStock& raw, const Lattice& lattice, float band)
      : raw_(raw), lattice_(lattice), band_(band) {}

  BlockChanges build(const Index3& corner, const IndexBox& clip) {
    divide(corner, kBlockEdge, clip);
    return std::move(changes_);
  }

 private:
  int side(const Index3& corner, int edge) const {
    return raw_side(raw_, lattice_, band_, corner, edge);
  }

  void divide(const Index3& corner, int edge, const IndexBox& clip) {
    const IndexBox cube = cube_at(corner, edge).common(clip);
    if (cube.voxels() == 0) return;
    const int where = side(corner, edge);
    if (where > 0) return;
    if (where < 0)
      return each_cube(cube, kLeafEdge,
                       [&](const Index3& c) { changes_.filled.push_back(coord(c)); });
    if (edge == kLeafEdge) return add_leaf(corner);
    each_cube(cube_at(corner, edge), edge / 2, [&](const Index3& c) { divide(c, edge / 2, clip); });
  }

  void add_leaf(const Index3& corner) {
    auto leaf = std::make_unique<Leaf>(coord(corner), band_, false);
    float* values = leaf->buffer().data();
    each_cube(cube_at(corner, kLeafEdge), kLeafEdge / 2,
              [&](const Index3& c) { fill(values, c, kLeafEdge / 2); });
    const auto [least, most] = std::minmax_element(values, values + kLeafVoxels);
    if (*least == band_) return;
    if (*most == -band_) return changes_.filled.push_back(coord(corner));
    mark_band(*leaf, band_);
    changes_.leaves.push_back(std::move(leaf));
  }

  void fill(float* values, const Index3& corner, int edge) const {
    const int where = side(corner, edge);
    if (edge > 2 && where == 0)
      return each_cube(cube_at(corner, edge), edge / 2,
                       [&](const Index3& c) { fill(values, c, edge / 2); });
    for (int x = corner[0]; x < corner[0] + edge; ++x)
      for (int y = corner[1]; y < corner[1] + edge; ++y)
        for (int z = corner[2]; z < corner[2] + edge; ++z)
          values[Leaf::coordToOffset({x, y, z})] =
              where == 0 ? exact({x, y, z}) : static_cast<float>(where) * band_;
  }
  float exact(const Index3& at) const {
    const auto d = static_cast<float>(raw_distance(raw_, lattice_.point(at)).distance);
    return std::clamp(d, -band_, band_);
  }

  const RawStock& raw_;
  const Lattice& lattice_;
  float band_;
  BlockChanges changes_;
};

}  // namespace

int raw_side(const RawStock& raw, const Lattice& lattice, double band_mm, const Index3& corner,
             int edge) {
  const double d = raw_distance(raw, lattice.middle(corner, edge)).distance;
  const double reach = lattice.half_diagonal(edge) + band_mm;
  return d > reach ? 1 : d < -reach ? -1 : 0;
}

void add_raw(Tree& tree, const RawStock& raw, const Lattice& lattice, const IndexBox& clip,
             const model::RunControl& control) {
  const float band = tree.background();
  std::vector<Index3> nodes, blocks;
  each_cube(clip, kNodeEdge, [&](const Index3& c) { nodes.push_back(c); });
  std::vector<int> side(nodes.size());
  model::parallel_for(nodes.size(), control.threads, [&](std::size_t i) {
    side[i] = raw_side(raw, lattice, band, nodes[i], kNodeEdge);
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (side[i] > 0) continue;
    const IndexBox node = cube_at(nodes[i], kNodeEdge);
    if (side[i] < 0 && clip.contains(node)) {
      tree.addTile(2, coord(nodes[i]), -band, false);
      continue;
    }
    each_cube(node.common(clip), kBlockEdge, [&](const Index3& c) { blocks.push_back(c); });
  }
  change_blocks(tree, blocks.size(), control, [&] {
    return [&](std::size_t i) { return RawBlock(raw, lattice, band).build(blocks[i], clip); };
  });
}

}  // namespace limitgauge::simulator::vdb
