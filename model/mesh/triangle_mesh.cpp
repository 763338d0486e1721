#include "model/mesh/triangle_mesh.h"

#include <utility>

namespace limitgauge::model {

Box3 bounding_box(const TriangleMesh& mesh) {
  Box3 box;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) box.add(mesh.vertices[v]);
  return box;
}

double area_mm2(const TriangleMesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& p = mesh.vertices[a];
    twice += length(cross(mesh.vertices[b] - p, mesh.vertices[c] - p));
  }
  return twice / 2;
}

double volume_mm3(const TriangleMesh& mesh) {
  // About the middle: far from the origin the terms would cancel.
  const Vec3 o = mesh.triangles.empty() ? Vec3{} : bounding_box(mesh).centre();
  double sixfold = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sixfold += dot(mesh.vertices[a] - o, cross(mesh.vertices[b] - o, mesh.vertices[c] - o));
  return sixfold / 6;
}

TriangleMesh placed(TriangleMesh mesh, double scale, const Vec3& translate_mm) {
  for (Vec3& v : mesh.vertices) v = v * scale + translate_mm;
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh, const Pose& pose) {
  for (Vec3& p : mesh.vertices) p = pose.point(p);
  return mesh;
}

}  // namespace limitgauge::model
