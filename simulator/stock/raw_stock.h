#pragma once

#include <optional>
#include <span>

#include "model/part/stock.h"
#include "simulator/mesh/mesh_solid.h"

namespace limitgauge::simulator {

/// Signed distance to the raw stock, negative inside, and its gradient.
struct RawSample {
  double distance = 0;
  model::Vec3 gradient;
};

/// The raw stock, prepared once for many questions. Immutable, cheap to copy.
class RawStock {
 public:
  /// Throws std::invalid_argument as model::require_valid does.
  explicit RawStock(const model::Stock& stock);

  /// Exact; 1-Lipschitz, also of a mesh (a sign that changes means a triangle between).
  RawSample distance(const model::Vec3& p) const;
  /// Distances at points of a vertical, `step_mm` apart upwards from p.
  void distances_up(const model::Vec3& p, double step_mm, std::span<double> out) const;
  /// Whether distance() is a convex function (its depth lies below its tangents): not of a mesh.
  bool convex() const { return !solid_; }
  const model::Box3& box() const { return box_; }
  double surface_area_mm2() const;
  const model::Stock& stock() const { return stock_; }
  /// Of a stock that is a mesh.
  const std::optional<MeshSolid>& solid() const { return solid_; }
  /// Of the mesh and its tree; a block or a bar needs none.
  std::size_t memory_bytes() const { return solid_ ? solid_->memory_bytes() : 0; }

 private:
  model::Stock stock_;
  model::Box3 box_;
  std::optional<MeshSolid> solid_;
};

inline RawSample raw_distance(const RawStock& stock, const model::Vec3& p) {
  return stock.distance(p);
}
inline double surface_area_mm2(const RawStock& stock) {
  return stock.surface_area_mm2();
}
inline const model::Box3& bounding_box(const RawStock& stock) {
  return stock.box();
}

}  // namespace limitgauge::simulator
