#pragma once

#include <cstdint>
#include <vector>

#include "model/base/run_control.h"
#include "model/part/toolpath.h"

namespace limitgauge::simulator {

/// Shape of a tree of median splits over the moves of a path: the same for any number of threads.
struct SweepOrder {
  /// Places in the path of the moves of slot 0, 1, ...: neighbours in space are near each other.
  std::vector<std::uint32_t> moves;
  struct Node {
    std::uint32_t first = 0;  ///< first slot of a leaf, or the first of two child nodes
    std::uint32_t count = 0;  ///< moves of a leaf, 0 for an inner node
  };
  /// The root first; children behind their parents.
  std::vector<Node> nodes;
};

/// Sorts by the middles of the moves, in O(n log n). Throws Interrupted when told to stop. Needs 36
/// bytes a move while it works.
SweepOrder order_moves(const model::Toolpath& path, const model::RunControl& control);

}  // namespace limitgauge::simulator
