#include "app/job_parts.h"
#include "app/toml_table.h"

namespace limitgauge::app {
namespace {

model::Stock read_box(const toml::table& table) {
  const TomlTable stock(table, "[stock]", {"shape", "size", "corner"});
  const model::Vec3 size = stock.vec3("size");
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
    throw model::InputError(stock.place("size"), "a size of the stock is not above zero",
                            "three numbers above zero");
  }
  return model::BoxStock{stock.vec3("corner"), size};
}

model::Stock read_cylinder(const toml::table& table) {
  const TomlTable stock(table, "[stock]", {"shape", "diameter", "height", "base"});
  return model::CylinderStock{stock.vec3("base"), stock.positive("diameter"),
                              stock.positive("height")};
}

}  // namespace

model::Stock read_stock(const toml::table& table) {
  // The keys depend on the shape, so the first look accepts them all.
  const TomlTable any(table, "[stock]",
                      {"shape", "size", "corner", "diameter", "height", "base", "file"});
  const std::string shape = any.one_of("shape", {"box", "cylinder", "mesh", "vdb"});
  if (shape == "box") return read_box(table);
  if (shape == "cylinder") return read_cylinder(table);
  throw model::InputError(any.place("shape"),
                          "stock of shape \"" + shape + "\" is not available in this release",
                          "\"box\" or \"cylinder\"");
}

}  // namespace limitgauge::app
