#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "model/base/run_control.h"
#include "simulator/grid/vdb_tree.h"

namespace limitgauge::simulator::vdb {

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
