#include "app/inputs/mesh_target.h"

#include <cmath>
#include <stdexcept>

#include "app/inputs/part_fit.h"
#include "app/inputs/surface_witness.h"
#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/part/target_mesh.h"

namespace limitgauge::app {
namespace {

/// The faceted cage and the mesh have the same vertices.
void place(model::TargetMesh& target, const Job& job) {
  target.cage = placed(target.cage, job.design->placement);
  target.mesh.vertices = target.cage.vertices;
  if (const model::Box3 box = bounding_box(target.mesh); !model::is_near(box))
    throw model::InputError({job.design->file.string()},
                            "the mesh reaches to " + model::farthest_words(box),
                            model::kFarthestExpected);
}

}  // namespace

JobSurface load_mesh_target(const Job& job, const model::RunControl& control) {
  model::TargetMesh target = model::read_target_mesh(job.design.value().file);
  place(target, job);
  require_fit(job, &target.cage);
  verifier::ReferenceSurface surface(target.mesh, control);
  control.check();
  witness::Agreement witness = witnessed_facets(target.cage, surface);
  return {std::move(target.cage), std::move(surface), std::move(witness),
          reports::MeshDesign{std::move(target.numbers), target.dropped_triangles}};
}

std::string mesh_like_warning(const model::CageSummary& cage) {
  constexpr int kFewFaces = 100;  // a coarse cage of triangles is as likely meant as one
  double triangles = 0;
  for (const auto& [corners, count] : cage.face_sizes)
    if (corners == 3) triangles = count;
  if (cage.faces < kFewFaces || triangles < kMeshLikeShare * cage.faces) return {};
  return std::to_string(std::lround(triangles)) + " of its " + std::to_string(cage.faces) +
         " faces are triangles: it looks like a mesh of the shape, but as a cage it stands for a "
         "smoother one that keeps away from its vertices; as a mesh it is taken by --target (in a "
         "job: mesh = in [surface])";
}

}  // namespace limitgauge::app
