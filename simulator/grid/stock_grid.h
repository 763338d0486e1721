#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include "model/base/run_control.h"
#include "model/mesh/triangle_mesh.h"
#include "simulator/grid/index_box.h"
#include "simulator/mesh/bent_cells.h"
#include "simulator/mesh/surface_net.h"
#include "simulator/stock/column_tops.h"
#include "simulator/stock/raw_stock.h"
#include "simulator/sweep/pass_reach.h"
#include "simulator/sweep/sweep_index.h"

namespace limitgauge::simulator {

/// Half width of the narrow band in voxels.
inline constexpr double kBandVoxels = 3;

/// The voxels of the blocks that the stock with its band lies in.
IndexBox stock_extent(const RawStock& raw, const Lattice& lattice);

/// Columns of one leaf's width over `extent`, with nothing standing.
ColumnTops empty_tops(const IndexBox& extent, const Lattice& lattice);

/// What a level set alone shows of a straight way: all of it up to `length_mm` is on one side. Of
/// no length where not even the start's side is shown.
struct GridRun {
  bool material = false;
  double length_mm = 0;
};

/// The narrow-band level set itself, or the part of it in a box: what holds OpenVDB's tree. A
/// value; copies share what they hold until one is cut.
class StockGrid {
 public:
  /// The raw stock's level set in `box`, whose sides are multiples of a block's edge, and `margin`
  /// voxels beyond its sides in x and y: a leaf is what the leaves of the box need of their
  /// neighbours.
  StockGrid(const RawStock& raw, const Lattice& lattice, const IndexBox& box, int margin,
            const model::RunControl& control);

  /// Where a pass reaches into this grid.
  PassReach reach(const SweepIndex& pass, const model::RunControl& control) const;
  /// This grid after a pass whose reach() is given. An rvalue that nobody shares is cut where it
  /// stands, with no second copy; where that throws, it is spent.
  StockGrid cut(const SweepIndex& pass, const PassReach& reach,
                const model::RunControl& control) const&;
  StockGrid cut(const SweepIndex& pass, const PassReach& reach,
                const model::RunControl& control) &&;
  bool shared() const { return impl_.use_count() > 1; }

  const Lattice& lattice() const;
  double band_mm() const { return kBandVoxels * lattice().voxel_mm; }
  const IndexBox& box() const;
  double value(const model::Vec3& p_mm) const;
  /// From `from` along a unit vector: φ is 1-Lipschitz, so a voxel at distance r shows its side of
  /// everything within |φ| − r.
  GridRun proven_run(const model::Vec3& from, const model::Vec3& along, double limit_mm) const;
  GridVolume volume(const model::RunControl& control) const;
  std::size_t memory_bytes() const;
  /// Leaves in the box, and beside it.
  std::size_t leaf_count() const;
  /// Voxels with another value than in `before`, a grid of the same lattice, that are in the narrow
  /// band of one of the two: leaf by leaf. What a cut had to write, less what it did by whole
  /// blocks.
  std::vector<Index3> changed_voxels(const StockGrid& before) const;
  /// An upper bound of the material's height over each column of one leaf's width of `extent`, for
  /// those in this grid's box. A column takes in half a voxel around its voxels' centres.
  void raise_tops(const IndexBox& extent, const model::RunControl& control, ColumnTops& tops) const;
  /// Over all of this grid's box.
  ColumnTops column_tops(const model::RunControl& control = {}) const;

  /// The surface between voxels inside and others, its vertices where `placers` puts them; see
  /// surface_net. Only for a grid of a whole stock.
  model::TriangleMesh mesh(const MakePlacer& placers, const model::RunControl& control) const;
  /// The same, or how much it would take where that is more than `most_bytes`.
  std::variant<model::TriangleMesh, NetSize> mesh_within(double most_bytes,
                                                         const MakePlacer& placers,
                                                         const model::RunControl& control) const;
  /// Throws ResourceError when the file cannot be written.
  void write(const std::filesystem::path& file, const model::Pose& pose, double blunt_mm) const;

 private:
  friend class GridLeaves;
  struct Impl;
  explicit StockGrid(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

/// The leaves of a grid's box, in the order of points: by the columns of blocks, x before y, then
/// by the blocks' z, then by the leaves' x, y, z in their block. The grid must outlive them.
class GridLeaves {
 public:
  explicit GridLeaves(const StockGrid& grid);
  ~GridLeaves();

  std::size_t size() const;
  Index3 corner(std::size_t leaf) const;
  /// Its voxels inside the material with one of their six neighbours outside, x before y before z.
  std::vector<Index3> surface_voxels(std::size_t leaf) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limitgauge::simulator
