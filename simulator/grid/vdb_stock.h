#pragma once

#include <cstddef>
#include <filesystem>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::simulator {

/// Stock of an earlier run.
struct VdbStock {
  model::TriangleMesh mesh;
  double voxel_mm = 0;
  double blunt_mm = 0;  ///< as MeshStock has it, by the file's word where it says so
};

inline constexpr std::size_t kVdbMemoryLimit = std::size_t{4} << 30;

/// The closed triangle mesh of the zero set of a level set, as tetrahedra.h has it; where faces
/// of the stock meet, it cuts the edge off, by `blunt_mm` at most. The file holds one grid, or one
/// named "stock": single precision, a level set, cubic voxels, turned and moved at most,
/// millimetres. Throws InputError for everything else that OpenVDB can tell, ResourceError where
/// the mesh would need more than `memory_limit_bytes`.
VdbStock read_vdb_stock(const std::filesystem::path& path,
                        std::size_t memory_limit_bytes = kVdbMemoryLimit);

}  // namespace limitgauge::simulator
