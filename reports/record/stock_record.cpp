#include "reports/record/stock_record.h"

#include <array>
#include <stdexcept>

#include "model/base/coordinate_limit.h"
#include "model/base/text_file.h"
#include "reports/record/json_value.h"
#include "reports/record/record_reader.h"

namespace limitgauge::reports::record {
namespace {

constexpr const char* kSchemaOfStock = "limitgauge.result/2";

void require_schema(const JsonValue& root) {
  const std::optional<JsonValue> schema = root.find("schema");
  if (!schema)
    root.refuse("has no key \"schema\"", std::string("a result of schema ") + kSchemaOfStock);
  if (schema->text() != kSchemaOfStock)
    schema->refuse("is another one, whose cutters and moves are not known as exactly",
                   std::string(kSchemaOfStock) + ": run it again with this version");
}

model::CutterType cutter_type(const JsonValue& value) {
  using model::CutterType;
  const std::string word = value.text();
  for (const CutterType type : {CutterType::flat, CutterType::ball, CutterType::bull,
                                CutterType::taper, CutterType::drill, CutterType::apt})
    if (word == model::name(type)) return type;
  value.refuse("is no type of cutter", "flat, ball, bull, taper, drill or apt");
}

model::Cutter read_cutter(const JsonValue& value) {
  model::Cutter cutter;
  cutter.type = cutter_type(value["type"]);
  cutter.diameter_mm = value["diameter_mm"].length();
  cutter.corner_radius_mm = value["corner_radius_mm"].length();
  cutter.flute_length_mm = value["flute_length_mm"].length();
  cutter.taper_angle_deg = value["taper_angle_deg"].number();
  cutter.tip_angle_deg = value["tip_angle_deg"].number();
  for (const double length : {cutter.diameter_mm, cutter.corner_radius_mm, cutter.flute_length_mm})
    if (!model::is_near(length)) value.refuse("is too large", model::kFarthestExpected);
  try {
    model::require_valid(cutter);
  } catch (const std::invalid_argument& error) {
    value.refuse(std::string("is no cutter: ") + error.what(), "a cutter as limitgauge writes it");
  }
  return cutter;
}

model::Pose read_pose(const JsonValue& setup) {
  // Of seventeen digits.
  constexpr double kWritten = 1e-12;
  const std::vector<JsonValue> rows = setup["rotation"].items();
  if (rows.size() != 3) setup["rotation"].refuse("has not three rows", "three rows of a rotation");
  try {
    model::Pose pose =
        model::rotation_of({rows[0].point(), rows[1].point(), rows[2].point()}, kWritten);
    pose.shift_mm = setup["origin_mm"].point();
    return pose;
  } catch (const std::invalid_argument& error) {
    setup["rotation"].refuse(error.what(), "three rows of a rotation");
  }
}

/// Of the setup that the stage names.
model::Pose pose_of(const JsonValue& stage, const std::vector<JsonValue>& setups) {
  const std::optional<JsonValue> named = stage.find("setup");
  if (!named) return {};
  for (const JsonValue& setup : setups)
    if (setup["name"].text() == named->text()) return read_pose(setup);
  named->refuse("is none of \"setups\"", "a result as limitgauge writes it");
}

StageCut read_stage_cut(const JsonValue& stage, const std::vector<JsonValue>& setups) {
  StageCut out;
  out.name = stage["name"].text();
  out.from_part = pose_of(stage, setups);
  out.verdict = read_verdict(stage["verdict"]);
  const std::optional<JsonValue> path = stage.find("toolpath");
  out.ran = path.has_value();
  if (!path) return out;
  out.cutter = read_cutter(stage["cutter"]);
  out.moves = (*path)["moves"].count();
  out.chord_error_mm = (*path)["chord_error_mm"].length();
  return out;
}

StockFileRecord read_stock_file(const JsonValue& stock, bool is_vdb) {
  StockFileRecord out{is_vdb, stock["file"].text(), stock["triangles"].count(), {}};
  const model::Vec3 corner = stock["corner_mm"].point();
  out.box_mm = {corner, corner + stock["size_mm"].point()};
  return out;
}

template <class Shape>
Shape valid(Shape shape, const JsonValue& stock) {
  try {
    model::require_valid(model::Stock(shape));
  } catch (const std::invalid_argument& error) {
    stock.refuse(std::string("is none: ") + error.what(), "a stock as limitgauge writes it");
  }
  if (!model::is_near(model::bounding_box(model::Stock(shape))))
    stock.refuse("lies too far out", model::kFarthestExpected);
  return shape;
}

void read_raw_stock(const JsonValue& stock, StockRecord& out) {
  const std::string shape = stock["shape"].text();
  if (shape == "box")
    out.raw = valid(model::BoxStock{stock["corner_mm"].point(), stock["size_mm"].point()}, stock);
  else if (shape == "cylinder")
    out.raw = valid(model::CylinderStock{stock["base_mm"].point(), stock["diameter_mm"].length(),
                                         stock["height_mm"].length()},
                    stock);
  else if (shape == "mesh" || shape == "vdb")
    out.raw = read_stock_file(stock, shape == "vdb");
  else
    stock["shape"].refuse("is none that is known", "box, cylinder, mesh or vdb");
}

}  // namespace

StockRecord read_stock_record(std::istream& in, const std::string& shown) {
  const nlohmann::json tree = parse_json(model::read_text(in, shown), shown);
  const JsonValue root(tree, shown);
  require_schema(root);
  StockRecord out;
  out.job = root["job"].text();
  out.version = root["version"].text();
  for (const JsonValue& input : root.items("inputs"))
    out.inputs.push_back({input["role"].text(), input["file"].text(), input["sha256"].text()});
  read_raw_stock(root["stock"], out);
  const std::vector<JsonValue> setups = root.items("setups");
  for (const JsonValue& stage : root["stages"].items())
    out.stages.push_back(read_stage_cut(stage, setups));
  return out;
}

}  // namespace limitgauge::reports::record
