#pragma once

#include <openvdb/openvdb.h>

#include "simulator/grid/block_cut.h"
#include "simulator/grid/index_box.h"
#include "simulator/grid/leaf_values.h"
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

}  // namespace limitgauge::simulator::vdb
