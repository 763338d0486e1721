#include "simulator/block_changes.h"

#include <algorithm>
#include <atomic>

namespace limitgauge::simulator::vdb {
namespace {

// Some tens of MiB of leaves at most.
constexpr std::size_t kBatch = 256;

}  // namespace

void BlockChanges::put_into(Tree& tree) {
  for (const Coord& c : emptied) tree.addTile(1, c, tree.background(), false);
  for (const Coord& c : filled) tree.addTile(1, c, -tree.background(), false);
  for (auto& leaf : leaves) tree.addLeaf(leaf.release());
  leaves.clear();
}

void change_blocks(Tree& tree, std::size_t count, const model::RunControl& control,
                   const std::function<BlockChanges(std::size_t)>& work) {
  std::atomic<std::size_t> done = 0;
  std::vector<BlockChanges> batch;
  for (std::size_t first = 0; first < count; first += kBatch) {
    batch.resize(std::min(kBatch, count - first));
    model::parallel_for(batch.size(), control.threads, [&](std::size_t i) {
      control.check();
      batch[i] = work(first + i);
      control.report(static_cast<double>(++done) / static_cast<double>(count));
    });
    for (BlockChanges& changes : batch) changes.put_into(tree);
  }
}

}  // namespace limitgauge::simulator::vdb
