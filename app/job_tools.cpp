#include <stdexcept>

#include "app/job_parts.h"
#include "app/nearest_key.h"
#include "app/toml_table.h"
#include "app/words.h"

namespace limitgauge::app {
namespace {

constexpr double kDefaultFluteDiameters = 4;

/// A cylinder, or several from the tip up.
std::vector<model::CylinderPart> read_parts(const TomlTable& tool, std::string_view key) {
  std::vector<model::CylinderPart> parts;
  if (!tool.has(key)) return parts;
  const auto add = [&](const toml::table& part) {
    const TomlTable reader(part, std::string(key) + " of " + tool.where(), {"diameter", "length"});
    parts.push_back({reader.positive("diameter"), reader.positive("length")});
  };
  if (tool.is_table(key)) {
    add(tool.table(key));
    return parts;
  }
  for (const toml::table* part : tool.tables(key)) add(*part);
  return parts;
}

model::CutterType type_of(const std::string& word) {
  if (word == "flat") return model::CutterType::flat;
  if (word == "ball") return model::CutterType::ball;
  if (word == "bull") return model::CutterType::bull;
  return model::CutterType::taper;
}

void refuse_foreign_keys(const TomlTable& tool, model::CutterType type) {
  const bool rounded = type == model::CutterType::bull || type == model::CutterType::taper;
  if (!rounded && tool.has("corner_radius")) {
    throw model::InputError(tool.place("corner_radius"),
                            std::string("a ") + name(type) + " cutter has no corner_radius",
                            "no such key, or type \"bull\" or \"taper\"");
  }
  if (type != model::CutterType::taper && tool.has("angle")) {
    throw model::InputError(tool.place("angle"),
                            std::string("a ") + name(type) + " cutter has no angle",
                            "no such key, or type \"taper\"");
  }
}

model::Cutter read_tool(const toml::table& table, JobContext& context) {
  const TomlTable tool(
      table, "[[tool]]",
      {"id", "type", "diameter", "corner_radius", "angle", "flute_length", "shank", "holder"});
  model::Cutter cutter;
  cutter.id = tool.text("id");
  cutter.type = type_of(tool.one_of("type", {"flat", "ball", "bull", "taper"}));
  refuse_foreign_keys(tool, cutter.type);
  cutter.diameter_mm = tool.positive("diameter");
  if (cutter.type == model::CutterType::ball) cutter.corner_radius_mm = cutter.diameter_mm / 2;
  if (cutter.type == model::CutterType::bull)
    cutter.corner_radius_mm = tool.positive("corner_radius");
  if (cutter.type == model::CutterType::taper) {
    cutter.corner_radius_mm = tool.has("corner_radius") ? tool.not_negative("corner_radius") : 0;
    cutter.taper_angle_deg = tool.positive("angle");
  }
  cutter.flute_length_mm = kDefaultFluteDiameters * cutter.diameter_mm;
  if (tool.has("flute_length")) {
    cutter.flute_length_mm = tool.positive("flute_length");
  } else {
    context.defaulted.push_back("tool " + cutter.id + ": flute length " +
                                words(cutter.flute_length_mm) + " mm (default: 4 diameters)");
  }
  cutter.shank = read_parts(tool, "shank");
  cutter.holder = read_parts(tool, "holder");
  try {
    require_valid(cutter);
  } catch (const std::invalid_argument& error) {
    throw model::InputError(tool.place(), "tool \"" + cutter.id + "\": " + error.what(),
                            "a cutter that can be made");
  }
  return cutter;
}

}  // namespace

std::vector<model::Cutter> read_tools(const std::vector<const toml::table*>& tools,
                                      JobContext& context) {
  std::vector<model::Cutter> cutters;
  for (const toml::table* table : tools) {
    model::Cutter cutter = read_tool(*table, context);
    for (const model::Cutter& other : cutters) {
      if (other.id != cutter.id) continue;
      throw model::InputError(place_of(table->get("id")->source()),
                              "a second tool \"" + cutter.id + "\"", "ids that differ");
    }
    cutters.push_back(std::move(cutter));
  }
  return cutters;
}

}  // namespace limitgauge::app
