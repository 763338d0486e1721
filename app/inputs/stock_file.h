#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/part/stock.h"

namespace limitgauge::app {

/// Raw stock from a file, and what of it is to stand among the report's assumptions.
struct StockFile {
  model::MeshStock stock;
  std::vector<std::string> assumptions;
};

/// Where the mesh of a file is put: every vertex times `scale`, then moved.
struct MeshPlace {
  double scale = 1;
  model::Vec3 translate_mm;
};

/// Throws InputError for a file that bounds no solid.
StockFile load_mesh_stock(const std::filesystem::path& file, const std::string& as_stated,
                          const MeshPlace& place);
/// Throws InputError for a file that is no stock of an earlier run, ResourceError where its mesh
/// would not fit into memory.
StockFile load_vdb_stock(const std::filesystem::path& file, const std::string& as_stated);

/// How a job's stock comes from its file: whoever reads many jobs need not read one file as often.
struct StockReaders {
  std::function<StockFile(const std::filesystem::path& file, const std::string& as_stated,
                          const MeshPlace& place)>
      mesh = load_mesh_stock;
  std::function<StockFile(const std::filesystem::path& file, const std::string& as_stated)> vdb =
      load_vdb_stock;
};

}  // namespace limitgauge::app
