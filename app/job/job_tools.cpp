#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "app/job/job_parts.h"
#include "app/toml/toml_table.h"
#include "model/base/coordinate_limit.h"
#include "model/part/cutter.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// A cylinder, or several from the tip up.
std::vector<model::CylinderPart> read_parts(const TomlTable& tool, std::string_view key) {
  std::vector<model::CylinderPart> parts;
  if (!tool.has(key)) return parts;
  const auto add = [&](const toml::table& part) {
    const TomlTable reader(part, std::string(key) + " of " + tool.where(), {"diameter", "length"});
    parts.push_back({reader.length_mm("diameter"), reader.length_mm("length")});
  };
  if (tool.is_table(key)) {
    add(tool.table(key));
    return parts;
  }
  for (const toml::table* part : tool.tables(key)) add(*part);
  return parts;
}

using model::CutterType;

CutterType type_of(const std::string& word) {
  for (const CutterType type :
       {CutterType::flat, CutterType::ball, CutterType::bull, CutterType::taper, CutterType::drill})
    if (word == name(type)) return type;
  return CutterType::apt;
}

/// Keys that only some types have.
struct ShapeKey {
  const char* key;
  std::initializer_list<CutterType> types;
};

std::string listed(const std::initializer_list<CutterType>& types) {
  std::string all;
  for (auto it = types.begin(); it != types.end(); ++it)
    all += std::string(it == types.begin()     ? ""
                       : it + 1 == types.end() ? " or "
                                               : ", ") +
           '"' + name(*it) + '"';
  return all;
}

void refuse_foreign_keys(const TomlTable& tool, CutterType type) {
  const ShapeKey keys[] = {
      {"corner_radius", {CutterType::bull, CutterType::taper, CutterType::apt}},
      {"angle", {CutterType::taper}},
      {"point_angle", {CutterType::drill}},
      {"tip_angle", {CutterType::apt}},
      {"side_angle", {CutterType::apt}},
      {"e", {CutterType::apt}},
      {"f", {CutterType::apt}}};
  for (const ShapeKey& shape : keys) {
    if (!tool.has(shape.key)) continue;
    if (std::find(shape.types.begin(), shape.types.end(), type) != shape.types.end()) continue;
    const std::string article = type == CutterType::apt ? "an " : "a ";
    throw model::InputError(tool.place(shape.key),
                            article + name(type) + " cutter has no " + shape.key,
                            "no such key, or type " + listed(shape.types));
  }
}

void read_shape(const TomlTable& tool, model::Cutter& cutter) {
  cutter.diameter_mm = tool.length_mm("diameter");
  switch (cutter.type) {
    case CutterType::flat:
      break;
    case CutterType::ball:
      cutter.corner_radius_mm = cutter.diameter_mm / 2;
      break;
    case CutterType::bull:
      cutter.corner_radius_mm = tool.length_mm("corner_radius");
      break;
    case CutterType::taper:
      cutter.corner_radius_mm =
          tool.has("corner_radius") ? tool.length_or_zero_mm("corner_radius") : 0;
      cutter.taper_angle_deg = tool.between("angle", 0, 90);
      break;
    case CutterType::drill:
      cutter.tip_angle_deg = (180 - tool.between("point_angle", 0, 180)) / 2;
      break;
    case CutterType::apt:
      cutter.corner_radius_mm = tool.length_or_zero_mm("corner_radius");
      cutter.tip_angle_deg = tool.not_negative("tip_angle");
      cutter.taper_angle_deg = tool.number("side_angle");
  }
}

void read_flute_length(const TomlTable& tool, model::Cutter& cutter, JobContext& context) {
  cutter.flute_length_mm = model::kDefaultFluteDiameters * cutter.diameter_mm;
  if (tool.has("flute_length")) {
    cutter.flute_length_mm = tool.length_mm("flute_length");
    return;
  }
  context.defaulted.push_back("tool " + cutter.id + ": flute length " +
                              model::shortest(cutter.flute_length_mm) +
                              " mm (default: 4 diameters)");
}

/// A cutter that cannot plunge and has no ramp angle goes down into nothing.
double steepest_descent_deg(const TomlTable& tool) {
  const bool states_plunge = tool.has("plunge"), states_ramp = tool.has("max_ramp_angle");
  const bool plunges = states_plunge ? tool.boolean("plunge") : !states_ramp;
  if (!states_ramp) return plunges ? 90 : 0;
  const double ramp_deg = tool.not_negative("max_ramp_angle");
  if (ramp_deg > 90)
    throw model::InputError(tool.place("max_ramp_angle"),
                            "\"max_ramp_angle\" in [[tool]] is " + model::shortest(ramp_deg),
                            "an angle from 0 to 90");
  if (states_plunge && plunges != (ramp_deg == 90))
    throw model::InputError(tool.place("max_ramp_angle"),
                            "\"max_ramp_angle\" " + model::shortest(ramp_deg) +
                                " contradicts plunge = " + (plunges ? "true" : "false"),
                            "one of the two keys");
  return ramp_deg;
}

void read_descent(const TomlTable& tool, model::Cutter& cutter, JobContext& context) {
  cutter.steepest_descent_deg = steepest_descent_deg(tool);
  if (tool.has("plunge") || tool.has("max_ramp_angle")) return;
  if (cutter.type == CutterType::flat || cutter.type == CutterType::bull)
    context.defaulted.push_back("tool " + cutter.id + ": taken to be able to plunge");
}

void require_cutter(const TomlTable& tool, const model::Cutter& cutter) {
  const auto refuse = [&](const model::SourcePlace& place, const char* wrong) {
    throw model::InputError(place, "tool \"" + cutter.id + "\": " + wrong,
                            "a cutter that can be made");
  };
  try {
    require_valid(cutter);
  } catch (const std::invalid_argument& error) {
    refuse(tool.place(), error.what());
  }
  for (const char* key : {"e", "f"}) {
    if (!tool.has(key)) continue;
    const double stated_mm = tool.number(key);
    const bool is_e = *key == 'e';
    try {
      require_centre(cutter, is_e ? &stated_mm : nullptr, is_e ? nullptr : &stated_mm);
    } catch (const std::invalid_argument& error) {
      refuse(tool.place(key), error.what());
    }
  }
}

/// What the machine's tool table knows of it.
void read_table_entry(const TomlTable& tool, JobTool& result) {
  if (tool.has("number")) result.number = tool.whole("number");
  if (!tool.has("length")) return;
  if (!result.number)
    throw model::InputError(tool.place("length"), "\"length\" of a tool without a number",
                            "\"number\" too: programs ask for a tool by it");
  result.length_mm = tool.length_mm("length");
}

JobTool read_tool(const toml::table& table, JobContext& context) {
  const TomlTable tool(table, "[[tool]]",
                       {"id", "type", "diameter", "corner_radius", "angle", "point_angle",
                        "tip_angle", "side_angle", "e", "f", "flute_length", "plunge",
                        "max_ramp_angle", "shank", "holder", "number", "length"});
  JobTool result;
  model::Cutter& cutter = result.cutter;
  cutter.id = tool.text("id");
  cutter.type = type_of(tool.one_of("type", {"flat", "ball", "bull", "taper", "drill", "apt"}));
  refuse_foreign_keys(tool, cutter.type);
  read_shape(tool, cutter);
  read_flute_length(tool, cutter, context);
  read_descent(tool, cutter, context);
  cutter.shank = read_parts(tool, "shank");
  cutter.holder = read_parts(tool, "holder");
  require_cutter(tool, cutter);
  read_table_entry(tool, result);
  return result;
}

void require_other(const toml::table& table, const JobTool& tool, const JobTool& before) {
  const auto refuse = [&](const char* key, const std::string& what, const char* expected) {
    throw model::InputError(place_of(table.get(key)->source()), "a second tool " + what, expected);
  };
  if (before.cutter.id == tool.cutter.id)
    refuse("id", "\"" + tool.cutter.id + "\"", "ids that differ");
  if (tool.number && before.number == tool.number)
    refuse("number", "T" + std::to_string(*tool.number), "numbers that differ");
}

}  // namespace

std::vector<JobTool> read_tools(const std::vector<const toml::table*>& tools, JobContext& context) {
  std::vector<JobTool> all;
  for (const toml::table* table : tools) {
    JobTool tool = read_tool(*table, context);
    for (const JobTool& before : all) require_other(*table, tool, before);
    all.push_back(std::move(tool));
  }
  return all;
}

}  // namespace limitgauge::app
