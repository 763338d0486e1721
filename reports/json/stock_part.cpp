#include "reports/json/stock_part.h"

#include "reports/text/text.h"

namespace limitgauge::reports::json {
namespace {

Json mesh_stock_part(const model::MeshStock& stock) {
  const model::Box3 box = bounding_box(*stock.mesh);
  Json out = {{"shape", stock.voxel_mm > 0 ? "vdb" : "mesh"},
              {"file", clean_text(stock.file)},
              {"triangles", stock.mesh->triangles.size()},
              {"corner_mm", point("stock.corner_mm", box.low)},
              {"size_mm", point("stock.size_mm", box.size())},
              {"volume_mm3", finite("stock.volume_mm3", volume_mm3(*stock.mesh))}};
  if (stock.voxel_mm > 0) out["voxel_mm"] = finite("stock.voxel_mm", stock.voxel_mm);
  return out;
}

}  // namespace

Json stock_part(const model::Stock& stock) {
  if (const auto* mesh = std::get_if<model::MeshStock>(&stock)) return mesh_stock_part(*mesh);
  if (const auto* box = std::get_if<model::BoxStock>(&stock))
    return {{"shape", "box"},
            {"corner_mm", point("stock.corner_mm", box->corner_mm)},
            {"size_mm", point("stock.size_mm", box->size_mm)}};
  const auto& bar = std::get<model::CylinderStock>(stock);
  return {{"shape", "cylinder"},
          {"base_mm", point("stock.base_mm", bar.base_mm)},
          {"diameter_mm", finite("stock.diameter_mm", bar.diameter_mm)},
          {"height_mm", finite("stock.height_mm", bar.height_mm)}};
}

}  // namespace limitgauge::reports::json
