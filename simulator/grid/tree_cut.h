#pragma once

#include "model/base/run_control.h"
#include "simulator/grid/vdb_tree.h"
#include "simulator/sweep/pass_reach.h"

namespace limitgauge::simulator::vdb {

/// Cuts `reach` out of the tree, whose leaves all lie in the box that it was worked out for. Where
/// it throws, part of the tree is cut.
void cut_tree(Tree& tree, const SweepIndex& pass, const Lattice& lattice, const PassReach& reach,
              const model::RunControl& control);

}  // namespace limitgauge::simulator::vdb
