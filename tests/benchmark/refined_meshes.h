#pragma once
// The aircraft's cage refined by CELL and by the libraries that others refine with, and what holds
// the points of two of them against each other.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

#include "engine/surface/cell/cell_patch.h"
#include "model/part/cage.h"

namespace limitgauge::benchmarks {

using SurfaceMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

const model::Cage& aircraft_cage();

/// All patches at `depth`, from the cage: its outer layer is built anew as well.
template <class Point>
std::vector<engine::surface::BasicCellPatch<Point>> cell_patches(int depth);

/// Refined in place, from the cage.
SurfaceMesh cgal_refined(int depth);

/// Single precision, as OpenSubdiv's own examples keep points.
struct FarPoint {
  float x = 0, y = 0, z = 0;
  void Clear() { x = y = z = 0; }
  void AddWithWeight(const FarPoint& other, float weight) {
    x += other.x * weight, y += other.y * weight, z += other.z * weight;
  }
};

/// Points of the last level, from the cage: the base level's topology is built anew as well.
std::vector<FarPoint> far_refined(int depth);

/// Largest distance of a point of `from` from the nearest point of `to` along a sorted axis: the
/// meshes are sampled, so that the search stays short.
double largest_gap(const std::vector<model::Vec3>& from, std::vector<model::Vec3> to);

std::vector<model::Vec3> points_of(const SurfaceMesh& mesh);

template <class Point>
std::vector<model::Vec3> points_of(
    const std::vector<engine::surface::BasicCellPatch<Point>>& patches) {
  std::vector<model::Vec3> points;
  for (const auto& patch : patches)
    for (int v = 0; v <= patch.cells(); ++v)
      for (int u = 0; u <= patch.cells(); ++u) points.push_back(patch.control(u, v));
  return points;
}

}  // namespace limitgauge::benchmarks
