#include "engine/surface/section/grid_section.h"

#include <utility>

#include "engine/surface/section/start_search.h"
#include "engine/surface/section/triangle_march.h"

namespace limitgauge::engine::surface {

GridSection::GridSection(Grid grid, int axis)
    : grid_(std::move(grid)), axis_(axis), tree_(grid_, axis) {}

SectionStarts GridSection::starts(std::span<const double> values) const {
  return StartSearch(grid_, axis_, tree_, values).run();
}

void GridSection::trace(const SectionStarts& starts, std::size_t plane, double value,
                        SectionScratch& scratch, std::vector<SectionChain>& chains) const {
  const TriangleMarch walk(grid_, {axis_, value});
  const int first_ring = starts.ring_offsets[plane], last_ring = starts.ring_offsets[plane + 1];
  // Only where rings are looked for it matters which curves are known.
  SectionScratch* visited = first_ring < last_ring ? &scratch : nullptr;
  const std::size_t total = 2 * grid_.points.size();
  if (visited && scratch.visited.size() < total) scratch.visited.resize(total, 0);
  for (int i = starts.line_offsets[plane]; i < starts.line_offsets[plane + 1]; ++i) {
    chains.emplace_back();
    chains.back().first = side_of(starts.lines[i]);
    chains.back().points.reserve(scratch.points + scratch.points / 16);
    walk.follow(starts.lines[i], chains.back(), visited);
    scratch.points = chains.back().points.size();
  }
  for (int i = first_ring; i < last_ring; ++i) {
    if (scratch.visited[triangle_of(starts.rings[i], grid_.columns)]) continue;
    chains.emplace_back();
    walk.follow(starts.rings[i], chains.back(), visited);
  }
  for (const int t : scratch.triangles) scratch.visited[t] = 0;
  scratch.triangles.clear();
}

void GridSection::cut(double value, SectionScratch& scratch,
                      std::vector<SectionChain>& chains) const {
  if (low() >= value || high() < value) return;
  trace(starts({&value, 1}), 0, value, scratch, chains);
}

}  // namespace limitgauge::engine::surface
