// Stands in for app/stock_file.cpp: meshes are read from the job's own folder alone, and stock of
// an earlier run, which would bring OpenVDB, is refused.
#include <memory>

#include "app/inputs/stock_file.h"
#include "model/base/error.h"
#include "model/mesh/mesh_reader.h"

namespace limitgauge::app {

StockFile load_mesh_stock(const std::filesystem::path& file, const std::string& as_stated,
                          const MeshPlace& place) {
  if (file.lexically_normal().parent_path() != LIMITGAUGE_FUZZ_JOB_FOLDER)
    throw model::InputError({file.string()}, "a file outside the job's folder", "one inside it");
  StockFile loaded;
  loaded.stock.mesh = std::make_shared<const model::TriangleMesh>(
      placed(model::read_triangle_mesh(file), place.scale, place.translate_mm));
  loaded.stock.file = as_stated;
  return loaded;
}

StockFile load_vdb_stock(const std::filesystem::path& file, const std::string&) {
  throw model::InputError({file.string()}, "stock of an earlier run", "a mesh");
}

}  // namespace limitgauge::app
