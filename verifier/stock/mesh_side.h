#pragma once

#include <cstdint>
#include <vector>

#include "verifier/stock/triangle_tree.h"

namespace limitgauge::verifier {

/// On which side of a closed mesh a point lies: inside where the mesh winds around it at least
/// once, counted along the vertical upwards. Whether the vertical meets a triangle is decided
/// exactly, and where it meets an edge or a vertex as for a point moved by (ε, ε²): every edge has
/// the point on the same side for both its triangles, so the count is right for any closed mesh,
/// also one that touches itself. Its exact predicate is the verifier's own: the proof that a point
/// lies outside the raw stock rests on it (CERTIFICATE.md), and none of it on the simulator. Only
/// for points of the mesh itself, within rounding, the side means nothing.
class MeshSide {
 public:
  /// `tree` must outlive it.
  explicit MeshSide(const TriangleTree& tree);
  bool inside(const model::Vec3& p) const;

 private:
  enum class Cell : std::uint8_t { unknown, mixed, inside, outside };

  bool winds_around(const model::Vec3& p) const;
  void mark(const Triangle& t);
  void fill(std::size_t cell, Cell side);
  model::Vec3 centre(std::size_t cell) const;
  /// Of the cells along an axis, the one that `at` lies in, or the nearest.
  std::int64_t place(int axis, double at) const;
  std::size_t index(std::int64_t i, std::int64_t j, std::int64_t k) const;

  const TriangleTree* tree_;
  /// Equal cubes over the box of the mesh: the side of those that no triangle comes near.
  std::vector<Cell> cells_;
  double size_mm_ = 0;
  std::int64_t counts_[3] = {};
};

}  // namespace limitgauge::verifier
