#include "simulator/sweep/pass_reach.h"

#include <algorithm>
#include <optional>

#include "simulator/grid/block_cut.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using Reach = BlockCutter::Reach;

/// Cubes that lie beside each other, asked for one by one: the move nearest to one is near to the
/// next, and whatever is farther need not be looked at.
class Neighbours {
 public:
  Neighbours(const SweepIndex& pass, const Lattice& lattice, double band_mm)
      : pass_(pass), lattice_(lattice), band_(band_mm) {}

  Reach reach(const Index3& corner, int edge) {
    const double reach = lattice_.half_diagonal(edge) + band_;
    const model::Vec3 middle = lattice_.middle(corner, edge);
    double bound = reach;
    if (last_)
      bound = std::min(bound, pass_.distance(last_->slot, middle).distance + kDistanceRounding_mm);
    const auto found = pass_.nearest(middle, bound);
    if (!found) return Reach::none;
    last_ = found;
    return BlockCutter::reach_of(found->at.distance, reach);
  }
  /// The move that reach() has found.
  const NearestMove& nearest() const { return *last_; }

 private:
  const SweepIndex& pass_;
  const Lattice& lattice_;
  double band_;
  std::optional<NearestMove> last_;
};

PassReach reach_in_node(Neighbours cubes, const Index3& corner, const IndexBox& box) {
  PassReach found;
  const IndexBox node = cube_at(corner, kNodeEdge);
  const Reach whole = cubes.reach(corner, kNodeEdge);
  if (whole == Reach::none) return found;
  if (whole == Reach::wholly && box.contains(node)) {
    found.swallowed_nodes.push_back(corner);
    return found;
  }
  each_cube(node.common(box), kBlockEdge, [&](const Index3& block) {
    const Reach reach = cubes.reach(block, kBlockEdge);
    if (reach == Reach::wholly) found.swallowed_blocks.push_back(block);
    if (reach != Reach::partly) return;
    found.partly.push_back(block);
    found.nearest.push_back(cubes.nearest());
  });
  return found;
}

}  // namespace

PassReach pass_reach(const SweepIndex& pass, const Lattice& lattice, double band_mm,
                     const IndexBox& box, const model::RunControl& control) {
  std::vector<Index3> nodes;
  each_cube(box, kNodeEdge, [&](const Index3& c) { nodes.push_back(c); });
  std::vector<PassReach> found(nodes.size());
  model::parallel_for(nodes.size(), control.threads, [&](std::size_t i) {
    control.check();
    found[i] = reach_in_node(Neighbours(pass, lattice, band_mm), nodes[i], box);
  });
  PassReach all;
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const PassReach& node : found) {
    append(all.partly, node.partly);
    append(all.nearest, node.nearest);
    append(all.swallowed_blocks, node.swallowed_blocks);
    append(all.swallowed_nodes, node.swallowed_nodes);
  }
  return all;
}

}  // namespace limitgauge::simulator
