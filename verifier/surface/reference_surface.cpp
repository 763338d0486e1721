#include "verifier/surface/reference_surface.h"

#include "model/part/target_mesh.h"
#include "verifier/surface/surface_tree.h"

namespace limitgauge::verifier {

ReferenceSurface::ReferenceSurface(const model::Cage& cage, const model::RunControl& control)
    : tree_(std::make_shared<const SurfaceTree>(cage, control)), rules_(rules_of(cage)) {}
ReferenceSurface::ReferenceSurface(const model::TriangleMesh& mesh,
                                   const model::RunControl& control)
    : tree_(std::make_shared<const SurfaceTree>(mesh, control)),
      rules_(rules_of(model::faceted_cage(mesh))) {}

int ReferenceSurface::patch_count() const {
  return tree_->patch_count();
}
bool ReferenceSurface::has_surface(int patch) const {
  return tree_->has_surface(patch);
}
SurfaceSample ReferenceSurface::evaluate(int patch, double u, double v) const {
  return tree_->evaluate(patch, u, v);
}
const model::Box3& ReferenceSurface::bounding_box() const {
  return tree_->bounding_box();
}
double ReferenceSurface::area_mm2() const {
  return tree_->area_mm2();
}
std::size_t ReferenceSurface::memory_bytes() const {
  return tree_->memory_bytes();
}

}  // namespace limitgauge::verifier
