#include "simulator/grid/tree_queries.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "model/base/chunks.h"
#include "simulator/mesh/net_cells.h"
#include "simulator/mesh/tetrahedra.h"

namespace limitgauge::simulator::vdb {
namespace {

constexpr std::size_t kChunk = 256;

// Orders leaves by block column, block, leaf: 19 bits each for x and y of blocks, 19 for z, 6 for
// the leaf in its block. OpenVDB's 32-bit voxels need no more than 27 of each; lattices here begin
// near zero and hold less than 2^18 blocks an axis.
std::uint64_t order_key(const Coord& c) {
  const auto block = [](int v) {
    return static_cast<std::uint64_t>((v >> 5) + (1 << 18)) & ((1U << 19) - 1);
  };
  const auto leaf = [](int v) { return static_cast<std::uint64_t>(v >> 3 & 3); };
  return ((block(c.x()) << 19 | block(c.y())) << 19 | block(c.z())) << 6 | leaf(c.x()) << 4 |
         leaf(c.y()) << 2 | leaf(c.z());
}
static_assert(kBlockEdge == 1 << 5 && kLeafEdge == 1 << 3);

template <class Visit>
void each_tile(const Tree& tree, const IndexBox& box, Visit visit) {
  auto tile = tree.cbeginValueAll();
  for (tile.setMaxDepth(Tree::ValueAllCIter::LEAF_DEPTH - 1); tile; ++tile) {
    if (*tile >= 0) continue;
    const openvdb::CoordBBox b = tile.getBoundingBox();
    const IndexBox part = IndexBox{index3(b.min()), index3(b.max().offsetBy(1))}.common(box);
    if (part.voxels() > 0) visit(part);
  }
}

void add_cell(const LeafPatch& patch, const Index3& in_leaf, const Index3& at, double voxel,
              GridVolume& volume) {
  std::array<double, 8> f;
  int inside = 0;
  for (int k = 0; k < 8; ++k) {
    f[k] = patch[patch_place(in_leaf[0] + (k >> 2 & 1), in_leaf[1] + (k >> 1 & 1),
                             in_leaf[2] + (k & 1))];
    inside += f[k] < 0;
  }
  if (inside == 0) return;
  if (inside == 8) return volume.linear.add_whole(1);
  const double share = negative_share(f);
  volume.linear.add_share(share);
  if (is_bent(f, voxel)) volume.bent.add(at, share);
}

// Cells whose lowest corner is in the leaf.
void add_leaf(const Tree& tree, const Leaf& leaf, double voxel, LeafPatch& patch,
              GridVolume& volume) {
  const double diagonal = std::sqrt(3.0) * voxel;
  const float* values = leaf.buffer().data();
  std::uint64_t near = 0, deep = 0;
  for (int n = 0; n < kLeafVoxels; ++n) {
    deep += values[n] < -diagonal;
    near += std::abs(values[n]) <= diagonal;
  }
  volume.linear.add_whole(deep);
  if (near == 0) return;
  fill_patch(tree, leaf, patch);
  const Index3 corner = index3(leaf.origin());
  for (int x = 0; x < kLeafEdge; ++x)
    for (int y = 0; y < kLeafEdge; ++y)
      for (int z = 0; z < kLeafEdge; ++z)
        if (std::abs(patch[patch_place(x, y, z)]) <= diagonal)
          add_cell(patch, {x, y, z}, {corner[0] + x, corner[1] + y, corner[2] + z}, voxel, volume);
}

bool negative_neighbours(const Accessor& tree, const Leaf& leaf, const float* values, int x, int y,
                         int z) {
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      int to[3] = {x, y, z};
      to[axis] += step;
      const bool in_leaf = to[axis] >= 0 && to[axis] < kLeafEdge;
      const float v = in_leaf ? values[leaf_place(to[0], to[1], to[2])]
                              : tree.getValue(leaf.origin().offsetBy(to[0], to[1], to[2]));
      if (v >= 0) return false;
    }
  return true;
}

/// The values of a leaf, or the one that a tile has everywhere, row by row along z.
struct LeafRows {
  const float* values;
  float everywhere;

  /// The first `n` of a row: with a count that the compiler knows, one load and one store.
  template <int n>
  void copy(int x, int y, float* to) const {
    if (values)
      std::copy_n(values + leaf_place(x, y, 0), n, to);
    else
      std::fill_n(to, n, everywhere);
  }
};

}  // namespace

std::vector<const Leaf*> ordered_leaves(const Tree& tree, const IndexBox& box) {
  std::vector<std::pair<std::uint64_t, const Leaf*>> keyed;
  keyed.reserve(tree.leafCount());
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    if (box.contains(index3(leaf->origin()))) keyed.emplace_back(order_key(leaf->origin()), &*leaf);
  std::sort(keyed.begin(), keyed.end());
  std::vector<const Leaf*> leaves;
  leaves.reserve(keyed.size());
  for (const auto& [key, leaf] : keyed) leaves.push_back(leaf);
  return leaves;
}

void fill_patch(const Tree& tree, const Leaf& leaf, LeafPatch& patch) {
  for (int k = 0; k < 8; ++k) {
    const int dx = k >> 2 & 1, dy = k >> 1 & 1, dz = k & 1;
    const Coord at = leaf.origin().offsetBy(dx * kLeafEdge, dy * kLeafEdge, dz * kLeafEdge);
    const Leaf* part = k == 0 ? &leaf : tree.probeConstLeaf(at);
    const LeafRows from{part ? part->buffer().data() : nullptr, part ? 0.0F : tree.getValue(at)};
    float* to = &patch[patch_place(dx * kLeafEdge, dy * kLeafEdge, dz * kLeafEdge)];
    for (int x = 0; x < (dx ? 1 : kLeafEdge); ++x)
      for (int y = 0; y < (dy ? 1 : kLeafEdge); ++y)
        dz ? from.copy<1>(x, y, to + patch_place(x, y, 0))
           : from.copy<kLeafEdge>(x, y, to + patch_place(x, y, 0));
  }
}

GridVolume volume(const Tree& tree, const std::vector<const Leaf*>& leaves, const IndexBox& box,
                  double voxel_mm, const model::RunControl& control) {
  GridVolume sum;
  each_tile(tree, box, [&](const IndexBox& tile) {
    sum.linear.add_whole(static_cast<std::uint64_t>(tile.voxels()));
  });
  std::vector<GridVolume> parts(model::chunk_count(leaves.size(), kChunk));
  model::parallel_chunks(leaves.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    LeafPatch patch;
    for (std::size_t i = begin; i < end; ++i)
      add_leaf(tree, *leaves[i], voxel_mm, patch, parts[begin / kChunk]);
  });
  for (const GridVolume& part : parts) sum += part;
  return sum;
}

std::vector<int> surface_voxels(const Tree& tree, const Leaf& leaf, double voxel_mm) {
  // A step to a neighbour changes φ by no more than a voxel, give or take single precision.
  const double deepest = -1.001 * voxel_mm;
  const float* values = leaf.buffer().data();
  const Accessor accessor(tree);
  std::vector<int> found;
  for (int x = 0; x < kLeafEdge; ++x)
    for (int y = 0; y < kLeafEdge; ++y)
      for (int z = 0; z < kLeafEdge; ++z) {
        const float v = values[leaf_place(x, y, z)];
        if (v < 0 && v > deepest && !negative_neighbours(accessor, leaf, values, x, y, z))
          found.push_back(leaf_place(x, y, z));
      }
  return found;
}

void raise_tops(const Tree& tree, const std::vector<const Leaf*>& leaves, const IndexBox& box,
                const IndexBox& extent, const Lattice& lattice, const model::RunControl& control,
                ColumnTops& tops) {
  const auto raise = [&](int x, int y, int z) {
    const int i = (x - extent.low[0]) / kLeafEdge, j = (y - extent.low[1]) / kLeafEdge;
    double& top = tops.top_mm[static_cast<std::size_t>(j) * tops.nx + i];
    top = std::max(top, lattice.origin_mm.z + (z + 1) * lattice.voxel_mm);
  };
  each_tile(tree, box, [&](const IndexBox& tile) {
    for (int x = tile.low[0]; x < tile.high[0]; x += kLeafEdge)
      for (int y = tile.low[1]; y < tile.high[1]; y += kLeafEdge) raise(x, y, tile.high[2] - 1);
  });
  // Material thinner than a voxel may miss every centre, but none by more than half a diagonal.
  const double near = 0.8661 * lattice.voxel_mm;
  std::vector<int> highest(leaves.size(), -1);
  model::parallel_chunks(leaves.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float* values = leaves[i]->buffer().data();
      for (int n = 0; n < kLeafVoxels; ++n)
        if (values[n] <= near) highest[i] = std::max(highest[i], n & (kLeafEdge - 1));
    }
  });
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Coord at = leaves[i]->origin();
    if (highest[i] >= 0) raise(at.x(), at.y(), at.z() + highest[i]);
  }
}

}  // namespace limitgauge::simulator::vdb
