#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <openvdb/openvdb.h>

#include "model/base/run_control.h"
#include "simulator/grid/block_cut.h"
#include "simulator/grid/index_box.h"
#include "simulator/grid/leaf_values.h"
#include "simulator/stock/raw_stock.h"
#include "simulator/sweep/pass_reach.h"

// What the sources that hold OpenVDB's tree share. Not for anyone else to include.
namespace limitgauge::simulator::vdb {

using openvdb::Coord;
using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using Accessor = openvdb::FloatGrid::ConstAccessor;

static_assert(Leaf::DIM == kLeafEdge);
inline constexpr int kLeafVoxels = static_cast<int>(Leaf::SIZE);
static_assert(Tree::RootNodeType::ChildNodeType::ChildNodeType::DIM == kNodeEdge);

inline Coord coord(const Index3& i) {
  return {i[0], i[1], i[2]};
}
inline Index3 index3(const Coord& c) {
  return {c[0], c[1], c[2]};
}

/// Makes the values within the band active and the others inactive, as OpenVDB's level set tools
/// want them.
inline void mark_band(Leaf& leaf, float band) {
  const LeafBits bits = within_band(leaf.buffer().data(), band);
  Leaf::NodeMaskType mask;
  for (std::size_t n = 0; n < bits.size(); ++n)
    mask.getWord<openvdb::Index64>(static_cast<openvdb::Index>(n)) = bits[n];
  leaf.setValueMask(mask);
}

/// Puts the raw stock's level set within `clip`, whose sides are multiples of a leaf's edge, into
/// an empty tree whose background is the band. The distance to the raw stock is asked for only
/// where cubes that it cannot decide from their middle are left, down to 2³ voxels: it may be
/// costly.
void add_raw(Tree& tree, const RawStock& raw, const Lattice& lattice, const IndexBox& clip,
             const model::RunControl& control);

/// Where a cube is: +1 wholly outside with its band, −1 wholly inside with it, 0 neither.
int raw_side(const RawStock& raw, const Lattice& lattice, double band_mm, const Index3& corner,
             int edge);

/// Cuts `reach` out of the tree, whose leaves all lie in the box that it was worked out for. Where
/// it throws, part of the tree is cut.
void cut_tree(Tree& tree, const SweepIndex& pass, const Lattice& lattice, const PassReach& reach,
              const model::RunControl& control);

/// What changes in one block besides the values of leaves that stand: worked out by any thread, put
/// into the tree by one.
struct BlockChanges {
  std::vector<std::unique_ptr<Leaf>> leaves;
  std::vector<Coord> emptied;  ///< leaves where nothing stands any more
  std::vector<Coord> filled;   ///< leaves wholly inside

  void put_into(Tree& tree);
};

/// Works out one block after the other.
using BlockWork = std::function<BlockChanges(std::size_t block)>;

/// Works out every block on the control's threads and puts what changes into the tree, a limited
/// number of blocks at a time: the tree stands still while blocks are worked out, and only so much
/// is held beside it. A block may read the whole tree and write to the values of its own leaves.
/// `start` makes what one thread works out a few blocks with.
void change_blocks(Tree& tree, std::size_t count, const model::RunControl& control,
                   const std::function<BlockWork()>& start);

}  // namespace limitgauge::simulator::vdb
