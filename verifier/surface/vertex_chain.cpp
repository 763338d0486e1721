#include "verifier/surface/vertex_chain.h"

namespace limitgauge::verifier {

using model::Index;
using model::Vec3;

namespace {

bool same_net(const Neighbourhood& a, const Neighbourhood& b) {
  return a.offsets == b.offsets && a.corners == b.corners && a.edge_sharpness == b.edge_sharpness &&
         a.vertex_sharpness == b.vertex_sharpness;
}

}  // namespace

std::shared_ptr<const ChainStep> ChainStep::of(const Neighbourhood& n, int corner) {
  std::shared_ptr<ChainStep> made(new ChainStep(n, corner));
  for (int k = 0; k < 4; ++k) {
    Refinement::Child child = made->step_.child(k);
    if (k == corner) {
      if (!same_net(child.net, n)) return nullptr;
      made->net_ = std::move(child.net), made->inner_ = std::move(child.from);
      continue;
    }
    auto grid = regular_grid(child.net);
    if (!grid) return nullptr;
    for (RegularGrid::Entry& e : grid->entries)
      if (!e.reflected) e.a = child.from[e.a];
    made->grids_[static_cast<std::size_t>(k)] = *grid;
  }
  return made;
}

std::vector<Vec3> ChainStep::inner(std::span<const Vec3> refined) const {
  std::vector<Vec3> points;
  points.reserve(inner_.size());
  for (const Index from : inner_) points.push_back(refined[from]);
  return points;
}

}  // namespace limitgauge::verifier
