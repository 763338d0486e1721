#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/model/run_control.h"
#include "engine/model/stock.h"
#include "simulator/lattice.h"
#include "simulator/stock_model.h"
#include "simulator/sweep_index.h"

namespace limitgauge::simulator {

/// Half width of the narrow band in voxels.
inline constexpr double kBandVoxels = 3;

/// How high material may stand over the square columns of a regular grid in x and y.
struct ColumnTops {
  model::Vec3 corner_mm;  ///< lower corner of the first column; z is of no account
  double edge_mm = 0;
  int nx = 0, ny = 0;
  std::vector<double> top_mm;  ///< x fastest; minus infinity where nothing stands
};

/// The narrow-band level set itself: the one place that knows OpenVDB. An immutable value, cheap
/// to copy.
class StockGrid {
 public:
  /// The raw stock's level set. Throws ResourceError when the forecast exceeds the limit.
  StockGrid(const model::Stock& raw, const Lattice& lattice, std::size_t memory_limit_bytes);

  /// This grid after a pass. Throws ResourceError when the forecast exceeds the limit.
  StockGrid cut(const model::Stock& raw, const SweepIndex& pass, std::size_t memory_limit_bytes,
                const model::RunControl& control) const;

  const Lattice& lattice() const;
  double band_mm() const { return kBandVoxels * lattice().voxel_mm; }
  double value(const model::Vec3& p_mm) const;
  double volume_mm3() const;
  std::size_t memory_bytes() const;
  /// Voxels of the narrow band: those with a value of their own, in all of the grid.
  std::size_t band_voxels() const;
  /// Voxels inside the material with one of their six neighbours outside, in the tree's order.
  std::vector<Index3> surface_voxels() const;
  /// An upper bound of the material's height over each column of one leaf's width. A column takes
  /// in half a voxel around its voxels' centres.
  ColumnTops column_tops() const;
  StockMesh mesh() const;
  /// Throws ResourceError when the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  struct Impl;
  explicit StockGrid(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace limitgauge::simulator
