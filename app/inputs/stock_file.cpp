#include "app/inputs/stock_file.h"

#include <cmath>
#include <memory>
#include <utility>

#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/mesh/mesh_defect.h"
#include "model/mesh/mesh_reader.h"
#include "model/text/number_text.h"
#include "simulator/grid/vdb_stock.h"

namespace limitgauge::app {
namespace {

model::MeshStock stock_of(model::TriangleMesh mesh, const std::string& as_stated, double voxel_mm) {
  return {std::make_shared<const model::TriangleMesh>(std::move(mesh)), as_stated, voxel_mm, 0};
}

StockFile near_stock(const std::filesystem::path& file, StockFile loaded) {
  const model::Box3 box = bounding_box(*loaded.stock.mesh);
  if (model::is_near(box)) return loaded;
  throw model::InputError({file.string()}, "the stock reaches to " + model::farthest_words(box),
                          model::kFarthestExpected);
}

bool is_moved(const MeshPlace& place) {
  return place.scale != 1 || !(place.translate_mm == model::Vec3{});
}

std::string rounded_up_mm(double length_mm) {
  return model::shortest(std::ceil(length_mm * 1000) / 1000) + " mm";
}

/// What holds no ball of such a diameter a level set may lack altogether: a ball of a voxel's
/// diagonal holds a node of the grid. Through another file before, it has to hold one such ball
/// when that one's blunt edge has been taken off all round.
double surely_kept_mm(const simulator::VdbStock& read) {
  const double diagonal_mm = model::kBluntVoxels * read.voxel_mm;
  constexpr double kRounding = 1e-9;
  const bool is_first = read.blunt_mm <= diagonal_mm * (1 + kRounding);
  return is_first ? diagonal_mm : 2 * read.blunt_mm;
}

}  // namespace

StockFile load_mesh_stock(const std::filesystem::path& file, const std::string& as_stated,
                          const MeshPlace& place) {
  model::MeshReading reading = model::read_mesh_file(file);
  if (is_moved(place)) {
    reading.mesh = placed(std::move(reading.mesh), place.scale, place.translate_mm);
    if (const auto defect = find_defect(reading.mesh))
      throw model::InputError({file.string()}, "scaled and moved: " + defect->wrong,
                              defect->expected);
  }
  StockFile loaded;
  if (reading.dropped_triangles > 0) {
    loaded.assumptions.push_back("stock " + as_stated +
                                 ": left out are triangles with two equal corners, " +
                                 std::to_string(reading.dropped_triangles) + " in number");
  }
  loaded.stock = stock_of(std::move(reading.mesh), as_stated, 0);
  return near_stock(file, std::move(loaded));
}

StockFile load_vdb_stock(const std::filesystem::path& file, const std::string& as_stated) {
  simulator::VdbStock read = simulator::read_vdb_stock(file);
  StockFile loaded;
  loaded.assumptions.push_back(
      "stock " + as_stated + ": taken as the triangle mesh of its zero set at a voxel of " +
      model::shortest(read.voxel_mm) +
      " mm; nothing is known of what cut it, nor of fins, pins, slots and sharp tips into which no "
      "ball of " +
      rounded_up_mm(surely_kept_mm(read)) +
      " fits, which such a file may lack altogether; other edges are blunt by up to " +
      rounded_up_mm(read.blunt_mm) +
      ", so that leftovers of it are taken to stand out that much more, and by as much grooves may "
      "be deeper and contacts with it be missed");
  loaded.stock = stock_of(std::move(read.mesh), as_stated, read.voxel_mm);
  loaded.stock.blunt_mm = read.blunt_mm;
  return near_stock(file, std::move(loaded));
}

}  // namespace limitgauge::app
