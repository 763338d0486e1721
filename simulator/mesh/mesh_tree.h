#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::simulator {

/// The triangles of a mesh in CGAL's tree of boxes (AABB_tree), and what CGAL's exact predicates
/// say of them. Triangles have the numbers that they have in the mesh. Immutable, cheap to copy;
/// may be asked from several threads at once.
class MeshTree {
 public:
  using Triangle = std::array<model::Vec3, 3>;

  /// The mesh has at least one triangle, all of vertices that exist and are finite.
  explicit MeshTree(const model::TriangleMesh& mesh);

  struct Nearest {
    std::uint32_t triangle = 0;
    model::Vec3 point;
    double distance_squared = 0;  ///< mm²
  };
  /// The distance is exact but for a few roundings of the coordinates, of slivers as well.
  /// `first_look` is a triangle that is likely to be near; it only saves time.
  Nearest nearest(const model::Vec3& p, std::optional<std::uint32_t> first_look = {}) const;
  /// The distance from p to one triangle.
  double distance_to(std::uint32_t triangle, const model::Vec3& p) const;

  /// Where a vertical passes through a triangle.
  struct Passage {
    std::uint32_t triangle = 0;
    int turns = 0;  ///< +1 through one that faces upwards, −1 downwards
  };
  /// Where the vertical through p passes through triangles above p (`is_above`). Decided exactly,
  /// as if p lay a little to +X, and far less to +Y, of where it is: over edges and vertices, too,
  /// of all triangles that meet there as many are passed as must be, so that the turns of a closed
  /// mesh sum up to its winding number.
  std::vector<Passage> passages_above(const model::Vec3& p) const;
  /// The same, for all the vertical.
  std::vector<Passage> passages(double x_mm, double y_mm) const;
  /// Whether a triangle, at a place where the vertical through p passes, lies above p; exact, and
  /// false where p is on its plane.
  bool is_above(const Passage& passage, const model::Vec3& p) const;
  /// The sum of the turns above p: how often a closed mesh goes around it.
  int winding(const model::Vec3& p) const;

  /// Calls `visit(triangle)` for all triangles whose boxes meet a cube about p and perhaps a few
  /// others, until it returns false. Whether it never did.
  bool each_about(const model::Vec3& p, double half_edge_mm,
                  const std::function<bool(std::uint32_t)>& visit) const;

  /// Looks for a least value over all triangles: `least_in` bounds it from below in a box, `look`
  /// looks at a triangle and returns the least value that is known by then. Triangles in boxes
  /// whose bound is not below that are left out; `least` is what it is at the start.
  void search(double least, const std::function<double(const model::Box3&)>& least_in,
              const std::function<double(std::uint32_t)>& look) const;

  Triangle triangle(std::uint32_t number) const;
  const model::Box3& box() const;
  std::size_t memory_bytes() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace limitgauge::simulator
