#include "verifier/surface/sharp_lines.h"

#include <algorithm>
#include <map>

#include "model/part/cage.h"
#include "verifier/surface/neighbourhood.h"

namespace limitgauge::verifier {
namespace {

using model::Index;

/// Numbers the patches as SurfaceTree does: a quad is one, another polygon one a corner.
std::vector<int> first_patches(const model::Cage& cage) {
  std::vector<int> first;
  int patch = 0;
  for (Index f = 0; f < cage.face_count(); ++f) {
    first.push_back(patch);
    const auto corners = static_cast<int>(cage.face(f).size());
    patch += corners == 4 ? 1 : corners;
  }
  return first;
}

/// The sides of patches along edge `k` of a face, from its own first vertex to the next.
std::vector<PatchSide> sides_of(int first_patch, int corners, int k) {
  if (corners == 4) return {{first_patch, k, 0, 1}};
  return {{first_patch + k, 0, 0, 0.5}, {first_patch + (k + 1) % corners, 3, 0.5, 1}};
}

}  // namespace

SharpLines::SharpLines(const model::Cage& cage) {
  const CageNeighbourhoods neighbourhoods(cage);
  const std::vector<int> first = first_patches(cage);
  std::map<std::pair<Index, Index>, double> sharpness;
  for (const model::Crease& c : cage.creases)
    sharpness[std::minmax(c.vertices[0], c.vertices[1])] = c.sharpness;
  std::map<Index, int> meeting;
  model::for_each_edge(model::sorted_edge_uses(cage), [&](std::span<const model::EdgeUse> uses) {
    const auto at = sharpness.find({uses[0].low, uses[0].high});
    if (at == sharpness.end() || at->second < model::kInfiniteSharpness) return;
    if (uses.size() != 2) return;
    SharpEdge edge;
    for (int n = 0; n < 2; ++n) {
      const model::EdgeUse& use = uses[n];
      if (!neighbourhoods.has_surface(use.face)) return;
      const Index begin = cage.face_offsets[use.face];
      const auto corners = static_cast<int>(cage.face_offsets[use.face + 1] - begin);
      edge.sides[n] = sides_of(first[use.face], corners, static_cast<int>(use.corner - begin));
      if (cage.face_corners[use.corner] == use.low) continue;
      for (PatchSide& s : edge.sides[n]) s.from = 1 - s.from, s.to = 1 - s.to;
    }
    edges.push_back(std::move(edge));
    ++meeting[uses[0].low], ++meeting[uses[0].high];
  });
  for (const model::Corner& c : cage.corners)
    if (c.sharpness >= model::kInfiniteSharpness) meeting[c.vertex] = 3;
  std::map<Index, std::vector<PatchCorner>> around;
  for (Index f = 0; f < cage.face_count(); ++f) {
    if (!neighbourhoods.has_surface(f)) continue;
    const auto corners = static_cast<int>(cage.face(f).size());
    for (int k = 0; k < corners; ++k) {
      const auto at = meeting.find(cage.face(f)[k]);
      if (at == meeting.end() || at->second < 3) continue;
      around[at->first].push_back(corners == 4 ? PatchCorner{first[f], k}
                                               : PatchCorner{first[f] + k, 0});
    }
  }
  for (auto& [vertex, list] : around)
    if (list.size() > 1) vertices.push_back(std::move(list));
}

}  // namespace limitgauge::verifier
