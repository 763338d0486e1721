#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "model/mesh/triangle_mesh.h"
#include "model/part/stock.h"
#include "model/part/toolpath.h"
#include "simulator/stock/stock_point.h"

namespace limitgauge::simulator {

using model::Pass;

/// A triangle mesh of the stock's surface.
using StockMesh = model::TriangleMesh;

/// The stock's surface as it is written out.
struct StockSurface {
  StockMesh mesh;           ///< closed, manifold, turned outwards
  double voxel_mm = 0;      ///< of the grid that it was taken from
  std::size_t unmoved = 0;  ///< vertices that could not be put onto the exact surface
};

/// What cutting a pass would take.
struct CutForecast {
  double bytes = 0;        ///< the model's after the cut, at most held while it runs
  double seconds = 0;      ///< on the control's threads, from a sample
  std::size_t blocks = 0;  ///< of 32³ voxels that the surface may pass through then
  bool tiled = false;      ///< would be worked out tile by tile
};

struct ColumnTops;
class Material;
class StockGrid;

/// What stands at one moment: a narrow-band level set φ in mm, negative inside the material,
/// φ = max(raw stock, −min over moves of the swept distance). A value, cheap to copy. The result of
/// cutting does not depend on the number of threads or the order of moves.
///
/// Where the whole level set would not fit into the memory, it is worked out tile by tile, from
/// the exact material, whenever it is asked for something. The volume, the points and the columns'
/// tops are the same to the last bit; what is drawn and written comes from a coarser whole grid.
class StockModel {
 public:
  /// Raw stock. Throws std::invalid_argument for a voxel that is not positive, ResourceError when
  /// not even a tile fits into `memory_limit_bytes`, naming a voxel that would do, Interrupted.
  StockModel(const model::Stock& raw, double voxel_mm, std::size_t memory_limit_bytes,
             const model::RunControl& control = {});
  ~StockModel();
  StockModel(const StockModel&);
  StockModel& operator=(const StockModel&);
  StockModel(StockModel&&) noexcept;
  StockModel& operator=(StockModel&&) noexcept;

  /// This stock after `pass`, which lies in this stock's frame as its pose says. Only feed and
  /// rapid moves' fluted part removes material. An rvalue
  /// whose level set nobody shares is cut where it stands, with no second copy of it; where that
  /// throws, it is spent: only to be destroyed or assigned to. Throws std::invalid_argument for a
  /// pass that cannot be, ResourceError, Interrupted.
  StockModel cut(const Pass& pass, const model::RunControl& control) const&;
  StockModel cut(const Pass& pass, const model::RunControl& control) &&;
  /// What that would take. Throws as cutting does.
  CutForecast forecast(const Pass& pass, const model::RunControl& control) const;

  double voxel_mm() const;
  double band_mm() const;  ///< |φ| is exact up to here and constant beyond
  /// From the level set, error of second order in the voxel; in cells where that is not linear,
  /// edges above all, from the exact material (GridVolume).
  double volume_mm3(const model::RunControl& control = {}) const;
  std::size_t memory_bytes() const;
  /// φ at `p_mm` by trilinear interpolation, clamped to ±band_mm(). Tile by tile it is the same but
  /// for the last bits of single precision.
  double value(const model::Vec3& p_mm) const;
  /// φ at `p_mm` computed from the raw stock and all moves cut so far, not interpolated.
  double exact_value(const model::Vec3& p_mm) const;
  /// The exact material behind exact_value(), with gradients; lives as long as this model.
  const Material& material() const;
  /// The level set that is held whole: at voxel_mm(), or coarsening() times as coarse where the
  /// model works tile by tile. Lives as long as this model.
  const StockGrid& grid() const;
  /// 1 where the level set is held whole, otherwise grid()'s voxel over voxel_mm().
  int coarsening() const;
  /// Tiles that the level set is worked out in, 0 where it is held whole.
  std::size_t tiles() const;
  /// An upper bound of the material's height over columns of eight voxels' width.
  ColumnTops column_tops(const model::RunControl& control = {}) const;

  /// Points of the surface, one per band voxel that it crosses: by the columns of 32² voxels that
  /// they lie in, x before y; in a column by blocks of 32³ from below; in a block by leaves of 8³,
  /// x before y before z, in a leaf by voxels likewise.
  std::vector<StockPoint> surface_points(const model::RunControl& control) const;
  /// Those of them that lie in `region`, by the centre of their voxel.
  std::vector<StockPoint> surface_points(const model::Box3& region,
                                         const model::RunControl& control) const;
  /// The same ones in the same order, some at a time: for when all would be too many to hold.
  void visit_surface_points(const model::Box3& region,
                            const std::function<void(std::span<const StockPoint>)>& visit,
                            const model::RunControl& control) const;
  /// Of a surface of this stock what a cutter made: without the triangles that lie on the raw
  /// stock's surface with all their corners and their middle. Open, turned outwards.
  StockMesh cut_part_of(const StockMesh& mesh, const model::RunControl& control = {}) const;
  /// The surface of grid(), its vertices on the exact one; of a coarser grid built for it where
  /// the mesh would not fit into the memory beside grid().
  StockSurface surface(const model::RunControl& control) const;
  /// The same net of grid() with its vertices left between the voxels, within about half a voxel
  /// of the surface: quick, for pictures.
  StockMesh surface_mesh(const model::RunControl& control = {}) const;
  /// grid() as OpenVDB writes it, its places moved by `pose`. Throws ResourceError.
  void write_vdb(const std::filesystem::path& file, const model::Pose& pose = {}) const;

 private:
  struct State;
  explicit StockModel(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

}  // namespace limitgauge::simulator
