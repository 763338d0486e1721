#pragma once

#include <vector>

#include "model/base/run_control.h"
#include "simulator/grid/vdb_tree.h"
#include "simulator/mesh/bent_cells.h"
#include "simulator/mesh/surface_net.h"
#include "simulator/stock/column_tops.h"

namespace limitgauge::simulator::vdb {

/// The tree's leaves in `box` by the columns of blocks that they lie in, x before y, then by the
/// blocks' z, then by their own x, y, z.
std::vector<const Leaf*> ordered_leaves(const Tree& tree, const IndexBox& box);

/// A leaf's values and the neighbours' beyond its upper faces.
void fill_patch(const Tree& tree, const Leaf& leaf, LeafPatch& patch);

/// The material whose cells begin in `box`.
GridVolume volume(const Tree& tree, const std::vector<const Leaf*>& leaves, const IndexBox& box,
                  double voxel_mm, const model::RunControl& control);

/// Offsets of the leaf's voxels that are inside with one of their six neighbours outside,
/// ascending.
std::vector<int> surface_voxels(const Tree& tree, const Leaf& leaf, double voxel_mm);

/// Raises the tops of the columns of `extent` that lie in `box` to an upper bound of the material's
/// height there. A column is of a leaf's width and takes in half a voxel around its voxels'
/// centres.
void raise_tops(const Tree& tree, const std::vector<const Leaf*>& leaves, const IndexBox& box,
                const IndexBox& extent, const Lattice& lattice, const model::RunControl& control,
                ColumnTops& tops);

}  // namespace limitgauge::simulator::vdb
