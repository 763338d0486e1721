#pragma once

#include <vector>

#include "model/base/run_control.h"
#include "simulator/grid/index_box.h"
#include "simulator/sweep/sweep_index.h"

namespace limitgauge::simulator {

/// Edge of the cubes that a pass is asked for first; of OpenVDB's lowest inner nodes, in voxels.
inline constexpr int kNodeEdge = 128;

/// The blocks of a box that a pass reaches into, and what it swallows whole with the band.
struct PassReach {
  std::vector<Index3> partly;
  std::vector<NearestMove> nearest;  ///< of each of these, to its middle; in the stock's frame
  std::vector<Index3> swallowed_blocks, swallowed_nodes;
};
PassReach pass_reach(const SweepIndex& pass, const Lattice& lattice, double band_mm,
                     const IndexBox& box, const model::RunControl& control);

}  // namespace limitgauge::simulator
