// The engine's limit meshes against the verifier's reference surface: two evaluators that share
// nothing but the cage.
#include <filesystem>

#include "engine/surface/cell/cell_patch.h"
#include "engine/surface/cell/corner_ring.h"
#include "engine/surface/finish_model.h"
#include "engine/surface/patch_model.h"
#include "model/part/cage_obj.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge {
namespace {

using model::Vec3;

model::Cage fixture(const char* name) {
  return model::read_cage_obj(tests::fixtures() / "cages" / name);
}

std::vector<model::Cage> cages() {
  std::vector<model::Cage> all = {fixture("aircraft.obj"), fixture("quick-dome.obj"),
                                  tests::cube_cage(), tests::paraboloid_cage(20, 0.01)};
  for (const int valence : {3, 5, 6, 8, 12}) all.push_back(tests::star_cage(valence, 1));
  model::Cage creased = tests::cube_cage();
  creased.creases = {{{4, 5}, 10}, {{5, 7}, 10}, {{6, 7}, 1.5}, {{4, 6}, 2}};
  all.push_back(creased);
  return all;
}

struct Mismatch {
  double position_mm = 0, normal = 0;
};

Mismatch compare(const model::Cage& cage) {
  const engine::surface::FinishModel finish(cage, {0.05, 0, 6}, {2, nullptr, {}});
  const verifier::ReferenceSurface reference(cage);
  Mismatch worst;
  int reference_patch = 0;
  for (const auto& patch : finish.patches().patches()) {
    while (!reference.has_surface(reference_patch)) ++reference_patch;
    const int n = patch.limit.cells();
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const auto s = reference.evaluate(reference_patch, static_cast<double>(i) / n,
                                          static_cast<double>(j) / n);
        const int at = patch.limit.index(i, j);
        worst.position_mm =
            std::max(worst.position_mm, distance(patch.limit.points[at], s.position));
        const bool corner = (i == 0 || i == n) && (j == 0 || j == n);
        if (!corner)
          worst.normal = std::max(worst.normal, distance(patch.limit.normals[at], s.normal));
      }
    ++reference_patch;
  }
  return worst;
}

}  // namespace

TEST_CASE("the engine's limit meshes lie on the reference surface", "[slow]") {
  for (const model::Cage& cage : cages()) {
    double size = 0;
    for (const Vec3& v : cage.vertices) size = std::max(size, length(v));
    const Mismatch worst = compare(cage);
    CAPTURE(cage.name, worst.position_mm, worst.normal);
    // A few hundred roundings of coordinates of this size.
    CHECK(worst.position_mm < 1e-12 * size);
    // Normals from differences of neighbours 2^-6 of a patch apart lose as many digits again.
    // Corners are left out: on creases each face has a normal of its own there.
    CHECK(worst.normal < 1e-9);
  }
}

TEST_CASE("corner rings of any valence reach the reference surface from depth 0 to 12", "[slow]") {
  using namespace engine::surface;
  constexpr int kDeepest = 12, kPatchDepth = 4;
  Mismatch ring_worst, patch_worst;
  for (int valence = 3; valence <= 50; ++valence) {
    const model::Cage cage = tests::star_cage(valence, 1);
    const verifier::ReferenceSurface reference(cage);
    const OuterMesh mesh = make_outer_mesh(cage);
    // Faces come in turn around vertex 0 and start with it; three of them see the ring turned.
    for (const int face : {0, 1, valence - 1}) {
      const auto vertex = reference.evaluate(face, 0, 0);
      CornerRing ring(mesh, mesh.face_offsets[face]);
      for (int depth = 0; depth <= kDeepest; ++depth) {
        if (depth > 0) ring.refine();
        ring_worst.position_mm =
            std::max(ring_worst.position_mm, distance(ring.limit_point(), vertex.position));
        ring_worst.normal =
            std::max(ring_worst.normal, distance(ring.limit_normal(), vertex.normal));
      }
    }
    for (CellPatch patch(mesh, 0); patch.depth() <= kPatchDepth; patch.refine()) {
      const LimitPatch limit = patch.limit();
      const int n = limit.cells();
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
          const auto s =
              reference.evaluate(0, static_cast<double>(i) / n, static_cast<double>(j) / n);
          const int at = limit.index(i, j);
          patch_worst.position_mm =
              std::max(patch_worst.position_mm, distance(limit.points[at], s.position));
          patch_worst.normal = std::max(patch_worst.normal, distance(limit.normals[at], s.normal));
        }
    }
  }
  CAPTURE(ring_worst.position_mm, ring_worst.normal, patch_worst.position_mm, patch_worst.normal);
  // Coordinates to 30 mm, a few hundred roundings.
  CHECK(ring_worst.position_mm < 1e-12);
  CHECK(patch_worst.position_mm < 1e-12);
  // Edges of the ring are down to 1e-4 mm long at depth 12 (0.41 a level at valence three), with
  // roundings of 1e-14 mm.
  CHECK(ring_worst.normal < 1e-9);
  CHECK(patch_worst.normal < 1e-10);
}

}  // namespace limitgauge
