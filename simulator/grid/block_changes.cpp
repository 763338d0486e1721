#include "simulator/grid/block_changes.h"

#include <algorithm>
#include <atomic>

#include "model/base/chunks.h"

namespace limitgauge::simulator::vdb {
namespace {

// Some tens of MiB of new leaves at most; a run shares buffers.
constexpr std::size_t kBatch = 256, kRun = 8;

}  // namespace

void BlockChanges::put_into(Tree& tree) {
  for (const Coord& c : emptied) tree.addTile(1, c, tree.background(), false);
  for (const Coord& c : filled) tree.addTile(1, c, -tree.background(), false);
  for (auto& leaf : leaves) tree.addLeaf(leaf.release());
  leaves.clear();
}

void change_blocks(Tree& tree, std::size_t count, const model::RunControl& control,
                   const std::function<BlockWork()>& start) {
  std::atomic<std::size_t> done = 0;
  std::vector<BlockChanges> batch;
  for (std::size_t first = 0; first < count; first += kBatch) {
    batch.resize(std::min(kBatch, count - first));
    model::parallel_chunks(batch.size(), kRun, control, [&](std::size_t begin, std::size_t end) {
      const BlockWork work = start();
      for (std::size_t i = begin; i < end; ++i) batch[i] = work(first + i);
      done += end - begin;
      control.report(static_cast<double>(done) / static_cast<double>(count));
    });
    for (BlockChanges& changes : batch) changes.put_into(tree);
  }
}

}  // namespace limitgauge::simulator::vdb
