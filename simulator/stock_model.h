#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/model/run_control.h"
#include "engine/model/stock.h"
#include "engine/model/triangle_mesh.h"
#include "simulator/pass.h"

namespace limitgauge::simulator {

/// A triangle mesh of the stock's surface.
using StockMesh = model::TriangleMesh;

/// A point of the stock's surface that has been moved onto the exact surface it belongs to (a swept
/// move or a face of the raw stock).
struct StockPoint {
  model::Vec3 position;
  double residual_mm = 0;  ///< |exact level set| there after projection; a bound on its error
};

class Material;
class StockGrid;

/// What stands at one moment: a narrow-band level set φ in mm, negative inside the material,
/// φ = max(raw stock, −min over moves of the swept distance). An immutable value, cheap to copy.
/// The result of cutting does not depend on the number of threads or the order of moves.
class StockModel {
 public:
  /// Raw stock. Throws std::invalid_argument for a voxel that is not positive, ResourceError when
  /// the forecast memory exceeds `memory_limit_bytes`.
  StockModel(const model::Stock& raw, double voxel_mm, std::size_t memory_limit_bytes);
  ~StockModel();
  StockModel(const StockModel&);
  StockModel& operator=(const StockModel&);
  StockModel(StockModel&&) noexcept;
  StockModel& operator=(StockModel&&) noexcept;

  /// This stock after `pass`. Only feed and rapid moves' fluted part removes material.
  StockModel cut(const Pass& pass, const model::RunControl& control) const;

  double voxel_mm() const;
  double band_mm() const;     ///< |φ| is exact up to here and constant beyond
  double volume_mm3() const;  ///< from the level set; error of second order in the voxel
  std::size_t memory_bytes() const;
  /// φ at `p_mm` by trilinear interpolation, clamped to ±band_mm().
  double value(const model::Vec3& p_mm) const;
  /// φ at `p_mm` computed from the raw stock and all moves cut so far, not interpolated.
  double exact_value(const model::Vec3& p_mm) const;
  /// The exact material behind exact_value(), with gradients; lives as long as this model.
  const Material& material() const;
  /// The level set itself; lives as long as this model.
  const StockGrid& grid() const;
  /// Points of the surface, one per band voxel that it crosses, in a fixed order.
  std::vector<StockPoint> surface_points(const model::RunControl& control) const;
  /// Those of them that lie in `region`, by the centre of their voxel.
  std::vector<StockPoint> surface_points(const model::Box3& region,
                                         const model::RunControl& control) const;
  /// Closed, manifold surface mesh.
  StockMesh surface_mesh() const;
  void write_vdb(const std::filesystem::path& file) const;  ///< throws ResourceError

 private:
  struct State;
  explicit StockModel(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace limitgauge::simulator
