#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/geometry/pose.h"

namespace limitgauge::model {

/// A triangle mesh, positions in mm; the vertices of a triangle go around it counter-clockwise when
/// seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Of the vertices that triangles use; empty for a mesh without triangles.
Box3 bounding_box(const TriangleMesh& mesh);
/// Of all triangles, cavities' walls included.
double area_mm2(const TriangleMesh& mesh);
/// What a closed mesh encloses; negative where its triangles go around the wrong way.
double volume_mm3(const TriangleMesh& mesh);
/// Every vertex times `scale`, then moved.
TriangleMesh placed(TriangleMesh mesh, double scale, const Vec3& translate_mm);
/// Every vertex moved by `pose`.
TriangleMesh turned(TriangleMesh mesh, const Pose& pose);

}  // namespace limitgauge::model
