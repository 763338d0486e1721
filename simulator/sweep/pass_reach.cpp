#include "simulator/sweep/pass_reach.h"

#include "simulator/grid/block_cut.h"

namespace limitgauge::simulator {
namespace {

using Reach = BlockCutter::Reach;

Reach node_reach(const SweepIndex& pass, const Lattice& lattice, double band_mm,
                 const Index3& corner) {
  const double reach = lattice.half_diagonal(kNodeEdge) + band_mm;
  const auto found = pass.nearest(lattice.middle(corner, kNodeEdge), reach);
  if (!found) return Reach::none;
  return found->at.distance < -reach ? Reach::wholly : Reach::partly;
}

}  // namespace

PassReach pass_reach(const SweepIndex& pass, const Lattice& lattice, double band_mm,
                     const IndexBox& box, const model::RunControl& control) {
  std::vector<Index3> nodes;
  each_cube(box, kNodeEdge, [&](const Index3& c) { nodes.push_back(c); });
  std::vector<PassReach> found(nodes.size());
  model::parallel_for(nodes.size(), control.threads, [&](std::size_t i) {
    control.check();
    const IndexBox node = cube_at(nodes[i], kNodeEdge);
    const Reach whole = node_reach(pass, lattice, band_mm, nodes[i]);
    if (whole == Reach::none) return;
    if (whole == Reach::wholly && box.contains(node))
      return found[i].swallowed_nodes.push_back(nodes[i]);
    each_cube(node.common(box), kBlockEdge, [&](const Index3& block) {
      const Reach reach = BlockCutter::reach(pass, lattice, band_mm, block);
      if (reach == Reach::partly) found[i].partly.push_back(block);
      if (reach == Reach::wholly) found[i].swallowed_blocks.push_back(block);
    });
  });
  PassReach all;
  const auto append = [](std::vector<Index3>& to, const std::vector<Index3>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const PassReach& node : found) {
    append(all.partly, node.partly);
    append(all.swallowed_blocks, node.swallowed_blocks);
    append(all.swallowed_nodes, node.swallowed_nodes);
  }
  return all;
}

}  // namespace limitgauge::simulator
