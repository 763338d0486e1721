#include "app/inputs/stock_file.h"
#include "app/job/job_parts.h"
#include "app/toml/toml_table.h"
#include "model/base/coordinate_limit.h"
#include "model/base/text_file.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// `key` is what makes the stock as large as it is.
model::Stock near_stock(const TomlTable& table, const char* key, model::Stock stock) {
  const model::Box3 box = bounding_box(stock);
  if (model::is_near(box)) return stock;
  throw model::InputError(
      table.place(key),
      "the stock reaches to " + model::farthest_words(box) + " by its \"" + key + "\"",
      model::kFarthestExpected);
}

model::Stock read_box(const toml::table& table) {
  const TomlTable stock(table, "[stock]", {"shape", "size", "corner"});
  const model::Vec3 size = stock.vec3("size");
  for (const int axis : {0, 1, 2}) {
    if (size[axis] >= model::kLeastLengthMm) continue;
    throw model::InputError(stock.place("size"),
                            "a size of the stock is " + model::six_digits(size[axis]) + " mm" +
                                (size[axis] > 0 ? "" : ", not above zero"),
                            "three lengths from 1e-6 mm on");
  }
  return near_stock(stock, "size", model::BoxStock{stock.position("corner"), size});
}

model::Stock read_cylinder(const toml::table& table) {
  const TomlTable stock(table, "[stock]", {"shape", "diameter", "height", "base"});
  const double diameter_mm = stock.length_mm("diameter"), height_mm = stock.length_mm("height");
  const char* const larger = diameter_mm > height_mm ? "diameter" : "height";
  return near_stock(stock, larger,
                    model::CylinderStock{stock.position("base"), diameter_mm, height_mm});
}

std::filesystem::path file_of(const TomlTable& stock, JobContext& context, const char* expected) {
  const std::filesystem::path file = context.folder / stock.text("file");
  if (!model::is_file(file)) {
    throw model::InputError(stock.place("file"), "no file \"" + stock.text("file") + "\"",
                            expected);
  }
  context.sources.push_back({JobFile::Role::stock, file, stock.text("file")});
  return file;
}

model::Stock taken(StockFile loaded, JobContext& context) {
  for (std::string& said : loaded.assumptions) context.defaulted.push_back(std::move(said));
  context.defaulted.push_back(
      "toolpaths that are planned here clear the box about the stock's mesh, not the mesh itself");
  return std::move(loaded.stock);
}

model::Stock read_mesh(const toml::table& table, JobContext& context) {
  const TomlTable stock(table, "[stock]", {"shape", "file", "translate", "scale"});
  MeshPlace place;
  if (stock.has("scale")) place.scale = stock.scale("scale");
  if (stock.has("translate")) place.translate_mm = stock.vec3("translate");
  const std::filesystem::path file =
      file_of(stock, context, "a closed mesh as STL, OBJ or PLY, in millimetres");
  return taken(context.stock_readers.mesh(file, stock.text("file"), place), context);
}

model::Stock read_vdb(const toml::table& table, JobContext& context) {
  const TomlTable stock(table, "[stock]", {"shape", "file"});
  const std::filesystem::path file = file_of(stock, context, "the stock.vdb of an earlier run");
  return taken(context.stock_readers.vdb(file, stock.text("file")), context);
}

}  // namespace

model::Stock read_stock(const toml::table& table, JobContext& context) {
  // The keys depend on the shape, so the first look accepts them all.
  const TomlTable any(
      table, "[stock]",
      {"shape", "size", "corner", "diameter", "height", "base", "file", "translate", "scale"});
  const std::string shape = any.one_of("shape", {"box", "cylinder", "mesh", "vdb"});
  if (shape == "box") return read_box(table);
  if (shape == "cylinder") return read_cylinder(table);
  return shape == "mesh" ? read_mesh(table, context) : read_vdb(table, context);
}

}  // namespace limitgauge::app
