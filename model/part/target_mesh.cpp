#include "model/part/target_mesh.h"

#include <algorithm>

#include "model/base/coordinate_limit.h"
#include "model/base/tolerance.h"
#include "model/mesh/mesh_reader.h"
#include "model/mesh/mesh_shells.h"

namespace limitgauge::model {
namespace {

/// Twice a triangle's area against the square of its longest edge: below, its three corners lie on
/// one line in double precision, and their cross product is rounding.
constexpr double kFlat = 1e-14;

std::array<Vec3, 3> corners_of(const TriangleMesh& mesh, std::size_t t) {
  std::array<Vec3, 3> p;
  for (int k = 0; k < 3; ++k) p[k] = mesh.vertices[mesh.triangles[t][k]];
  return p;
}

void require_near(const TriangleSoup& soup, const MeshReading& read) {
  for (std::size_t t = 0; t < read.mesh.triangles.size(); ++t)
    for (const Vec3& p : corners_of(read.mesh, t))
      if (!is_near(p))
        fail_at_triangle(soup, read.numbers[t], "a corner lies at " + farthest_words(p),
                         kFarthestExpected);
}

void require_areas(const TriangleSoup& soup, const MeshReading& read) {
  for (std::size_t t = 0; t < read.mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners_of(read.mesh, t);
    const double longest =
        std::max({length_squared(b - a), length_squared(c - b), length_squared(a - c)});
    if (!(length(cross(b - a, c - a)) > kFlat * longest))
      fail_at_triangle(soup, read.numbers[t],
                       "its corners lie on one line, so that it has no normal",
                       "triangles with an area; mesh repair tools call these degenerate");
  }
}

void require_manifold(const TriangleSoup& soup, const MeshReading& read, const Cage& cage) {
  const std::vector<CageDefect> defects = find_defects(cage);
  if (defects.empty()) return;
  const CageDefect& first = defects.front();
  const auto fail = [&](const char* wrong) {
    fail_at_triangle(soup, read.numbers[static_cast<std::size_t>(first.face)], wrong,
                     "a mesh in which two triangles at most meet at an edge and those at a vertex "
                     "hang together, all oriented alike");
  };
  switch (first.kind) {
    case CageDefect::Kind::non_manifold_edge:
      fail("more than two triangles meet at one of its edges");
      break;
    case CageDefect::Kind::non_manifold_vertex:
      fail("at one of its corners triangles meet in a point only");
      break;
    case CageDefect::Kind::flipped_face:
      fail("it goes round the other way than its neighbour");
      break;
    case CageDefect::Kind::degenerate_face:
      fail("two of its corners are one point");
  }
}

/// Two triangles of the same three corners, back to back.
void require_unfolded(const TriangleSoup& soup, const MeshReading& read) {
  using Keyed = std::pair<std::array<std::uint32_t, 3>, std::size_t>;
  std::vector<Keyed> all;
  for (std::size_t t = 0; t < read.mesh.triangles.size(); ++t) {
    all.emplace_back(read.mesh.triangles[t], t);
    std::ranges::sort(all.back().first);
  }
  std::ranges::sort(all);
  const auto pair = std::ranges::adjacent_find(all, {}, &Keyed::first);
  if (pair != all.end())
    fail_at_triangle(soup, read.numbers[std::next(pair)->second],
                     "it lies back on triangle " + std::to_string(read.numbers[pair->second] + 1),
                     "triangles that do not lie on each other");
}

/// What a body that is inside out needs cut is what others need to stand.
void require_outside_out(const TriangleSoup& soup, const MeshReading& read) {
  constexpr const char* kTurned =
      "triangles whose corners go round counter-clockwise seen from outside";
  const MeshShells all = shells_of(read.mesh);
  const auto shell = inside_out_shell(read.mesh, all);
  if (!shell) return;
  if (all.shells.size() == 1)
    throw InputError({soup.file}, "the mesh is inside out: its normals point into the material",
                     kTurned);
  fail_at_triangle(soup, read.numbers[all.shells[*shell].first_triangle],
                   "its body is inside out and no cavity of another: its normals point into the "
                   "material",
                   kTurned);
}

}  // namespace

Cage faceted_cage(const TriangleMesh& mesh) {
  Cage cage;
  cage.boundary = BoundaryRule::edge_and_corner;
  cage.vertices = mesh.vertices;
  cage.face_corners.reserve(3 * mesh.triangles.size());
  cage.face_offsets.reserve(mesh.triangles.size() + 1);
  for (const auto& t : mesh.triangles)
    cage.add_face(
        std::array{static_cast<Index>(t[0]), static_cast<Index>(t[1]), static_cast<Index>(t[2])});
  for_each_edge(sorted_edge_uses(cage), [&](std::span<const EdgeUse> uses) {
    if (uses.size() > 1) cage.creases.push_back({{uses[0].low, uses[0].high}, kInfiniteSharpness});
  });
  for (Index v = 0; v < static_cast<Index>(cage.vertices.size()); ++v)
    cage.corners.push_back({v, kInfiniteSharpness});
  return cage;
}

bool is_open(const Cage& faceted) {
  // A closed one has one and a half edges a triangle.
  return 2 * faceted.creases.size() < faceted.face_corners.size();
}

TargetMesh target_mesh(const TriangleSoup& soup) {
  MeshReading read = joined(soup);
  if (read.mesh.triangles.empty())
    throw InputError({soup.file}, "the mesh has no triangle with an area", "a mesh of a design");
  require_near(soup, read);
  require_areas(soup, read);
  Cage cage = faceted_cage(read.mesh);
  require_manifold(soup, read, cage);
  require_unfolded(soup, read);
  require_outside_out(soup, read);
  return {std::move(read.mesh), std::move(cage), std::move(read.numbers), read.dropped_triangles};
}

TargetMesh read_target_mesh(const std::filesystem::path& path) {
  return target_mesh(read_mesh_soup(path));
}

}  // namespace limitgauge::model
