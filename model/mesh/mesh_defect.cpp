#include "model/mesh/mesh_defect.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "model/base/tolerance.h"
#include "model/mesh/mesh_shells.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::string text_of(const Vec3& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

/// Also where a coordinate is no number.
bool beyond_reach(const Vec3& p) {
  return !(std::abs(p.x) <= kFarthestCoordinate_mm && std::abs(p.y) <= kFarthestCoordinate_mm &&
           std::abs(p.z) <= kFarthestCoordinate_mm);
}

std::optional<MeshDefect> corner_defect(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v >= mesh.vertices.size())
        return MeshDefect{t, "there is no vertex " + std::to_string(v),
                          "at most " + std::to_string(mesh.vertices.size()) + " vertices"};
      if (!is_finite(mesh.vertices[v]))
        return MeshDefect{t, "a coordinate is not a finite number", "millimetres"};
      if (beyond_reach(mesh.vertices[v]))
        return MeshDefect{t, "the vertex " + text_of(mesh.vertices[v]) + " is more than 1 km off",
                          "millimetres"};
    }
  }
  return std::nullopt;
}

/// A triangle's way along an edge, kept with the edge's lower vertex.
struct EdgeUse {
  std::uint32_t other = 0;  ///< the edge's higher vertex
  std::uint32_t triangle = 0;
  bool upwards = false;  ///< from the lower to the higher vertex
  friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
    return a.other != b.other ? a.other < b.other : a.triangle < b.triangle;
  }
};

/// The uses of all edges, sorted by their lower vertex: `first[v]` is where those of v begin.
struct EdgeTable {
  std::vector<std::uint64_t> first;
  std::vector<EdgeUse> uses;
};

template <class Visit>
void each_edge(const Triangle& t, Visit&& visit) {
  for (int k = 0; k < 3; ++k)
    if (const std::uint32_t a = t[k], b = t[(k + 1) % 3]; a != b) visit(a, b);
}

EdgeTable edge_table(const TriangleMesh& mesh) {
  EdgeTable table;
  table.first.assign(mesh.vertices.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
    each_edge(t, [&](std::uint32_t a, std::uint32_t b) { ++table.first[std::min(a, b) + 1]; });
  std::partial_sum(table.first.begin(), table.first.end(), table.first.begin());
  table.uses.resize(table.first.back());
  std::vector<std::uint64_t> next(table.first.begin(), table.first.end() - 1);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    each_edge(mesh.triangles[i], [&](std::uint32_t a, std::uint32_t b) {
      table.uses[next[std::min(a, b)]++] = {std::max(a, b), i, a < b};
    });
  return table;
}

MeshDefect edge_defect(const TriangleMesh& mesh, std::uint32_t low, const EdgeUse* begin,
                       const EdgeUse* end) {
  const auto uses = static_cast<std::size_t>(end - begin);
  const std::string edge =
      text_of(mesh.vertices[low]) + " to " + text_of(mesh.vertices[begin->other]);
  std::string expected = "a closed mesh, two triangles at every edge";
  if (uses % 2 != 0)
    return {begin->triangle,
            uses == 1 ? "the edge " + edge + " has one triangle only"
                      : "the edge " + edge + " has " + std::to_string(uses) + " triangles",
            std::move(expected)};
  return {begin->triangle, "the edge " + edge + " is passed the same way by two triangles",
          "triangles that go around counter-clockwise seen from outside"};
}

/// Of the edges that are not passed as often one way as the other, the one that the first triangle
/// of all has.
std::optional<MeshDefect> closing_defect(const TriangleMesh& mesh) {
  EdgeTable table = edge_table(mesh);
  std::uint32_t low_of_worst = 0;
  const EdgeUse *worst = nullptr, *worst_end = nullptr;
  for (std::uint32_t v = 0; v + 1 < table.first.size(); ++v) {
    EdgeUse* const all_end = table.uses.data() + table.first[v + 1];
    EdgeUse* begin = table.uses.data() + table.first[v];
    std::sort(begin, all_end);
    for (EdgeUse* end = begin; begin != all_end; begin = end) {
      std::ptrdiff_t balance = 0;
      for (; end != all_end && end->other == begin->other; ++end) balance += end->upwards ? 1 : -1;
      if (balance != 0 && (worst == nullptr || begin->triangle < worst->triangle))
        low_of_worst = v, worst = begin, worst_end = end;
    }
  }
  if (worst == nullptr) return std::nullopt;
  return edge_defect(mesh, low_of_worst, worst, worst_end);
}

std::optional<MeshDefect> volume_defect(const TriangleMesh& mesh) {
  const MeshShells all = shells_of(mesh);
  for (const Shell& s : all.shells)
    if (!s.encloses_volume())
      return MeshDefect{s.first_triangle, "the shell of this triangle encloses no volume",
                        "a mesh that bounds a solid"};
  constexpr const char* kTurn =
      "triangles that go around counter-clockwise seen from outside (turn them: flip the normals)";
  if (std::ranges::none_of(all.shells, [](const Shell& s) { return s.volume_mm3 > 0; }))
    return MeshDefect{{}, "the mesh is inside out", kTurn};
  if (const auto shell = inside_out_shell(mesh, all))
    return MeshDefect{all.shells[*shell].first_triangle,
                      "the shell of this triangle is inside out and no cavity of another", kTurn};
  return std::nullopt;
}

}  // namespace

std::optional<MeshDefect> find_defect(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return MeshDefect{{}, "the mesh has no triangles", "a closed mesh"};
  if (mesh.triangles.size() >= UINT32_MAX || mesh.vertices.size() >= UINT32_MAX)
    return MeshDefect{{}, "the mesh has more than 4294967294 triangles or vertices", "fewer"};
  if (auto defect = corner_defect(mesh)) return defect;
  if (auto defect = closing_defect(mesh)) return defect;
  return volume_defect(mesh);
}

}  // namespace limitgauge::model
