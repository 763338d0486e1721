#include "tests/simulator/mesh/mesh_check.h"

#include <map>
#include <unordered_map>
#include <vector>

namespace limitgauge::simulator::test {
namespace {

// The triangles about a vertex, as links from the vertex after it to the one after that: one fan
// is one closed chain of all of them.
bool one_fan(const std::vector<std::array<std::uint32_t, 2>>& links) {
  std::unordered_map<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : links)
    if (!next.emplace(from, to).second) return false;
  std::uint32_t at = links.front()[0];
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto found = next.find(at);
    if (found == next.end()) return false;
    at = found->second;
    if (at == links.front()[0]) return i + 1 == links.size();
  }
  return false;
}

}  // namespace

MeshFaults faults(const model::TriangleMesh& mesh) {
  MeshFaults found;
  std::map<std::array<std::uint32_t, 2>, int> directed;
  std::vector<std::vector<std::array<std::uint32_t, 2>>> links(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      ++directed[{t[k], t[(k + 1) % 3]}];
      links[t[k]].push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
    }
  for (const auto& [edge, count] : directed) {
    const auto reverse = directed.find({edge[1], edge[0]});
    found.edges += edge[0] == edge[1] || count != 1 || reverse == directed.end();
  }
  for (const auto& fan : links) {
    found.unused += fan.empty();
    found.fans += !fan.empty() && !one_fan(fan);
  }
  return found;
}

double enclosed_volume(const model::TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.triangles)
    volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
  return volume;
}

}  // namespace limitgauge::simulator::test
