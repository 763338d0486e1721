#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "model/geometry/pose.h"
#include "model/mesh/triangle_mesh.h"

namespace limitgauge::model {

/// Raw stock: an axis-aligned block.
struct BoxStock {
  Vec3 corner_mm;  ///< lower corner
  Vec3 size_mm;
};
/// Raw stock: an upright round bar, axis along +Z.
struct CylinderStock {
  Vec3 base_mm;  ///< centre of the lower face
  double diameter_mm = 0;
  double height_mm = 0;
};

/// Voxels that an edge or a corner of a solid may stand out beyond the zero set of its level set:
/// the diagonal of a cell. Where the zero set is further away than that all nodes about a place are
/// outside, and what stands there is thinner than a voxel.
inline constexpr double kBluntVoxels = 1.7320508075688772;

/// Raw stock: the solid that a closed triangle mesh bounds, in the job's frame. Never null in a
/// valid stock.
struct MeshStock {
  std::shared_ptr<const TriangleMesh> mesh;
  std::string file;     ///< as the job states it
  double voxel_mm = 0;  ///< 0: `file` is a mesh; else the voxel of the `.vdb` it was taken from
  /// How far edges of what the `.vdb` was written of may stand out beyond the mesh: kBluntVoxels of
  /// it and of each stock before that it came from; of a mesh 0.
  double blunt_mm = 0;
};

/// Raw stock: a block or a bar that does not stand along the axes.
struct LeaningStock {
  std::variant<BoxStock, CylinderStock> upright;  ///< in a frame of its own
  Pose pose;                                      ///< of that frame in the job's
};

using Stock = std::variant<BoxStock, CylinderStock, MeshStock, LeaningStock>;

/// MeshStock::blunt_mm; of any other stock 0.
double blunt_mm(const Stock& stock);

/// Of a mesh, one look at every triangle: keep it where it is asked for often.
Box3 bounding_box(const Stock& stock);
/// Throws std::invalid_argument for a zero, negative or non-finite size and for a mesh that bounds
/// no solid (mesh_defect.h).
void require_valid(const Stock& stock);
/// The stock moved by `pose`. A block whose sides stay along the axes stays one, and so does a bar
/// whose axis stays along Z; otherwise they lean.
Stock turned(const Stock& stock, const Pose& pose);
/// What toolpaths are planned for: a block or bar as it stands, and of a mesh or what leans the box
/// about it. A path that clears the box clears the stock.
Stock planned_stock(const Stock& stock);
/// `box:LX,LY,LZ@X,Y,Z`: size @ lower corner. Throws InputError with the column in `text`.
Stock parse_stock(std::string_view text);

}  // namespace limitgauge::model
