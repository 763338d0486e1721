#include "simulator/grid/vdb_tree.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "model/base/chunks.h"
#include "simulator/grid/leaf_values.h"
#include "simulator/stock/raw_stock.h"

namespace limitgauge::simulator::vdb {
namespace {

class RawBlock {
 public:
  RawBlock(const RawStock& raw, const Lattice& lattice, float band)
      : raw_(raw), lattice_(lattice), band_(band) {}

  BlockChanges build(const Index3& corner, const IndexBox& clip) {
    divide(corner, kBlockEdge, clip);
    return std::move(changes_);
  }

 private:
  int side(const Index3& corner, int edge) const {
    return raw_side(raw_, lattice_, band_, corner, edge);
  }

  void divide(const Index3& corner, int edge, const IndexBox& clip) {
    const IndexBox cube = cube_at(corner, edge).common(clip);
    if (cube.voxels() == 0) return;
    const int where = side(corner, edge);
    if (where > 0) return;
    if (where < 0)
      return each_cube(cube, kLeafEdge,
                       [&](const Index3& c) { changes_.filled.push_back(coord(c)); });
    if (edge == kLeafEdge) return add_leaf(corner);
    each_cube(cube_at(corner, edge), edge / 2, [&](const Index3& c) { divide(c, edge / 2, clip); });
  }

  void add_leaf(const Index3& corner) {
    auto leaf = std::make_unique<Leaf>(coord(corner), band_, false);
    float* values = leaf->buffer().data();
    each_cube(cube_at(corner, kLeafEdge), kLeafEdge / 2,
              [&](const Index3& c) { fill(values, c, kLeafEdge / 2); });
    const auto [least, most] = std::minmax_element(values, values + kLeafVoxels);
    if (*least == band_) return;
    if (*most == -band_) return changes_.filled.push_back(coord(corner));
    mark_band(*leaf, band_);
    changes_.leaves.push_back(std::move(leaf));
  }

  void fill(float* values, const Index3& corner, int edge) const {
    const int where = side(corner, edge);
    if (edge > 2 && where == 0)
      return each_cube(cube_at(corner, edge), edge / 2,
                       [&](const Index3& c) { fill(values, c, edge / 2); });
    for (int x = corner[0]; x < corner[0] + edge; ++x)
      for (int y = corner[1]; y < corner[1] + edge; ++y)
        for (int z = corner[2]; z < corner[2] + edge; ++z)
          values[Leaf::coordToOffset({x, y, z})] =
              where == 0 ? exact({x, y, z}) : static_cast<float>(where) * band_;
  }
  float exact(const Index3& at) const {
    const auto d = static_cast<float>(raw_distance(raw_, lattice_.point(at)).distance);
    return std::clamp(d, -band_, band_);
  }

  const RawStock& raw_;
  const Lattice& lattice_;
  float band_;
  BlockChanges changes_;
};

}  // namespace

int raw_side(const RawStock& raw, const Lattice& lattice, double band_mm, const Index3& corner,
             int edge) {
  const double d = raw_distance(raw, lattice.middle(corner, edge)).distance;
  const double reach = lattice.half_diagonal(edge) + band_mm;
  return d > reach ? 1 : d < -reach ? -1 : 0;
}

void add_raw(Tree& tree, const RawStock& raw, const Lattice& lattice, const IndexBox& clip,
             const model::RunControl& control) {
  const float band = tree.background();
  std::vector<Index3> nodes, blocks;
  each_cube(clip, kNodeEdge, [&](const Index3& c) { nodes.push_back(c); });
  std::vector<int> side(nodes.size());
  model::parallel_for(nodes.size(), control.threads, [&](std::size_t i) {
    side[i] = raw_side(raw, lattice, band, nodes[i], kNodeEdge);
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (side[i] > 0) continue;
    const IndexBox node = cube_at(nodes[i], kNodeEdge);
    if (side[i] < 0 && clip.contains(node)) {
      tree.addTile(2, coord(nodes[i]), -band, false);
      continue;
    }
    each_cube(node.common(clip), kBlockEdge, [&](const Index3& c) { blocks.push_back(c); });
  }
  change_blocks(tree, blocks.size(), control, [&] {
    return [&](std::size_t i) { return RawBlock(raw, lattice, band).build(blocks[i], clip); };
  });
}

namespace {

// In which leaves of a block something stands. A block that is worked out stays as it is but for
// the values of its leaves, so that these need to be looked up once.
class StandingLeaves {
 public:
  StandingLeaves(const Tree& tree, const Index3& block) : block_(block) {
    const openvdb::tree::ValueAccessor<const Tree, false> near(tree);
    each_cube(cube_at(block, kBlockEdge), kLeafEdge, [&](const Index3& c) {
      const bool stands = near.probeConstLeaf(coord(c)) != nullptr || near.getValue(coord(c)) < 0;
      bits_ |= std::uint64_t{stands} << place(c);
    });
  }

  bool any() const { return bits_ != 0; }
  bool any(const Index3& corner, int edge) const {
    if (edge == kLeafEdge) return (bits_ >> place(corner) & 1U) != 0;
    bool found = false;
    each_cube(cube_at(corner, edge), kLeafEdge,
              [&](const Index3& c) { found = found || any(c, kLeafEdge); });
    return found;
  }

 private:
  static constexpr int kLeaves = kBlockEdge / kLeafEdge;  // along an edge
  int place(const Index3& leaf) const {
    const auto along = [&](int axis) { return (leaf[axis] - block_[axis]) / kLeafEdge; };
    return (along(0) * kLeaves + along(1)) * kLeaves + along(2);
  }

  Index3 block_;
  std::uint64_t bits_ = 0;
};
static_assert(kBlockEdge / kLeafEdge == 4);

// Leaves that stand already are written in place, the rest is noted.
class Cut : public LeafSink {
 public:
  Cut(Tree& tree, const Index3& block) : tree_(tree), standing_(tree, block) {}

  bool any() const { return standing_.any(); }
  bool wanted(const Index3& corner, int edge) const override { return standing_.any(corner, edge); }
  void removed(const Index3& corner, int edge) override {
    each_cube(cube_at(corner, edge), kLeafEdge, [&](const Index3& c) {
      if (wanted(c, kLeafEdge)) changes_.emptied.push_back(coord(c));
    });
  }
  void reached(const Index3& corner, const LeafDistances& distances) override {
    const Coord at = coord(corner);
    if (Leaf* leaf = tree_.probeLeaf(at)) return lower(*leaf, distances);
    // Wholly inside so far: a leaf is made only where something changes and something stands.
    const float band = tree_.background();
    const auto [least, most] = value_range(distances);
    if (least == band) return;
    if (most == -band) return changes_.emptied.push_back(at);
    auto leaf = std::make_unique<Leaf>(at, -band, false);
    lower(*leaf, distances);
    changes_.leaves.push_back(std::move(leaf));
  }
  BlockChanges take() { return std::move(changes_); }

 private:
  void lower(Leaf& leaf, const LeafDistances& distances) {
    const float band = tree_.background();
    const LoweredLeaf lowered = lower_values(distances, leaf.buffer().data());
    if (!lowered.changed) return;
    if (lowered.least == band) return changes_.emptied.push_back(leaf.origin());
    mark_band(leaf, band);
  }

  Tree& tree_;
  StandingLeaves standing_;
  BlockChanges changes_;
};

// Cutters that are not at work: each keeps the room that it has taken.
class Cutters {
 public:
  Cutters(const SweepIndex& pass, const Lattice& lattice, double band_mm)
      : pass_(pass), lattice_(lattice), band_(band_mm) {}

  /// One for as long as it is held.
  std::shared_ptr<BlockCutter> take() {
    const std::scoped_lock lock(guard_);
    std::unique_ptr<BlockCutter> one;
    if (idle_.empty()) {
      one = std::make_unique<BlockCutter>(pass_, lattice_, band_);
    } else {
      one = std::move(idle_.back());
      idle_.pop_back();
    }
    return {one.release(), [this](BlockCutter* used) {
              const std::scoped_lock giving(guard_);
              idle_.emplace_back(used);
            }};
  }

 private:
  const SweepIndex& pass_;
  const Lattice& lattice_;
  double band_;
  std::mutex guard_;
  std::vector<std::unique_ptr<BlockCutter>> idle_;
};

}  // namespace

void cut_tree(Tree& tree, const SweepIndex& pass, const Lattice& lattice, const PassReach& reach,
              const model::RunControl& control) {
  for (const Index3& node : reach.swallowed_nodes)
    tree.addTile(2, coord(node), tree.background(), false);
  for (const Index3& block : reach.swallowed_blocks) {
    Cut cut(tree, block);
    cut.removed(block, kBlockEdge);
    cut.take().put_into(tree);
  }
  const double band = tree.background();
  Cutters cutters(pass, lattice, band);
  // A turned pass is cut in a frame of its own, and what it was asked is in the stock's.
  const auto known = [&](std::size_t i) {
    return pass.turned() ? std::nullopt : std::optional(reach.nearest[i]);
  };
  change_blocks(tree, reach.partly.size(), control, [&] {
    return [&, cutter = cutters.take()](std::size_t i) {
      Cut cut(tree, reach.partly[i]);
      if (cut.any()) cutter->cut(reach.partly[i], cut, known(i));
      return cut.take();
    };
  });
}

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
