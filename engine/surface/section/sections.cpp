#include "engine/surface/section/sections.h"

#include <optional>

#include "engine/surface/section/section_merge.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::surface {
namespace {

/// Planes cut by one thread at a time, sharing scratch memory.
constexpr std::size_t kPlanesAChunk = 32;

}  // namespace

std::vector<GridSection> section_trees(const OffsetModel& sampled, int axis,
                                       const model::RunControl& control) {
  std::vector<std::optional<GridSection>> built(sampled.grids.size());
  model::parallel_chunks(built.size(), 1, control, [&](std::size_t g, std::size_t) {
    built[g].emplace(sampled.grids[g], axis);
  });
  std::vector<GridSection> trees;
  trees.reserve(built.size());
  for (auto& tree : built) trees.push_back(std::move(*tree));
  return trees;
}

std::vector<std::vector<SectionCurve>> sections(const PatchModel& model, const OffsetModel& sampled,
                                                std::span<const GridSection> trees,
                                                std::span<const double> values,
                                                const model::RunControl& control) {
  std::vector<SectionStarts> starts(trees.size());
  model::parallel_chunks(trees.size(), 1, control,
                         [&](std::size_t g, std::size_t) { starts[g] = trees[g].starts(values); });
  std::vector<std::vector<SectionCurve>> curves(values.size());
  model::parallel_chunks(
      values.size(), kPlanesAChunk, control, [&](std::size_t begin, std::size_t end) {
        // Patch by patch: neighbouring planes go through the same memory.
        SectionScratch scratch;
        std::vector<SectionMerge> merges(end - begin, SectionMerge(model, sampled));
        std::vector<SectionChain> chains;
        for (std::size_t g = 0; g < trees.size(); ++g) {
          if (starts[g].empty()) continue;
          for (std::size_t k = begin; k < end; ++k) {
            chains.clear();
            trees[g].trace(starts[g], k, values[k], scratch, chains);
            merges[k - begin].add(static_cast<int>(g), chains);
          }
        }
        for (std::size_t k = begin; k < end; ++k) curves[k] = merges[k - begin].curves();
      });
  return curves;
}

std::vector<std::vector<SectionCurve>> sections(const PatchModel& model, const OffsetModel& sampled,
                                                int axis, std::span<const double> values,
                                                const model::RunControl& control) {
  return sections(model, sampled, section_trees(sampled, axis, control), values, control);
}

std::vector<SectionCurve> section(const PatchModel& model, const OffsetModel& sampled,
                                  const AxisPlane& plane) {
  return sections(model, sampled, plane.axis, {&plane.value, 1}, {}).front();
}

}  // namespace limitgauge::engine::surface
