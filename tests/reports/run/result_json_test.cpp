#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/record/record_reader.h"
#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using Json = nlohmann::ordered_json;

namespace {

std::string json_text_of(const RunResult& result) {
  std::ostringstream out;
  write_result_json(result, out);
  return out.str();
}

Json json_of(const RunResult& result) {
  return Json::parse(json_text_of(result));
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

/// What `part` of the schema stands for once its references are followed.
Json resolved(const Json& schema, Json part) {
  while (part.contains("$ref"))
    part = schema.at(Json::json_pointer(part["$ref"].get<std::string>().substr(1)));
  if (part.contains("allOf")) return resolved(schema, part["allOf"][0]);
  return part;
}

/// Every key that is written must be described.
void require_described(const Json& schema, const Json& part, const Json& value,
                       const std::string& where) {
  const Json here = resolved(schema, part);
  if (value.is_object()) {
    for (const auto& item : value.items()) {
      INFO(where << "/" << item.key());
      REQUIRE(here["properties"].contains(item.key()));
      require_described(schema, here["properties"][item.key()], item.value(),
                        where + "/" + item.key());
    }
  } else if (value.is_array()) {
    for (const Json& item : value) require_described(schema, here["items"], item, where + "[]");
  }
}

}  // namespace

TEST_CASE("result.json has the contract's keys", "[unit][json]") {
  const Json root = json_of(sample_result(Outcome::failed));
  for (const char* key :
       {"schema", "job", "version", "created", "threads", "verdict", "surface", "stages"})
    CHECK(root.contains(key));
  CHECK(root["schema"] == "limitgauge.result/2");
  for (const char* key : {"cage", "patches", "faces", "boundary_edges", "extraordinary_vertices",
                          "bbox_mm", "depth", "sampling_interval", "seconds", "memory_bytes"})
    CHECK(root["surface"].contains(key));
  const Json& stage = root["stages"][1];
  for (const char* key : {"name", "tool", "strategy", "allowance_mm", "verdict", "reasons",
                          "toolpath", "simulation", "deviation", "seconds"})
    CHECK(stage.contains(key));
  for (const char* key : {"moves", "planes", "cut_length_mm", "rapid_length_mm", "machining_time_s",
                          "seconds", "memory_bytes"})
    CHECK(stage["toolpath"].contains(key));
  for (const char* key : {"voxel_mm", "removed_volume_mm3", "seconds", "peak_memory_bytes",
                          "rapid_collisions", "holder_collisions"})
    CHECK(stage["simulation"].contains(key));
  for (const char* key :
       {"gouge_mm", "uncut_mm", "coverage", "mean_mm", "rms_mm", "p01_mm", "p50_mm", "p99_mm",
        "voxel_gouge_mm", "voxel_uncut_mm", "unreachable_area_mm2", "unavoidable_uncut_mm",
        "histogram", "gouges", "uncuts"})
    CHECK(stage["deviation"].contains(key));
  for (const char* phase : {"reach", "certificate", "field", "unavoidable", "rays", "findings"})
    CHECK(stage["deviation"]["phases"][phase].contains("seconds"));
  for (const char* key : {"x", "y", "z", "depth_mm", "area_mm2", "patch", "u", "v", "line", "move"})
    CHECK(stage["deviation"]["gouges"][0].contains(key));
  for (const char* key : {"line", "x", "y", "z", "depth_mm"})
    CHECK(stage["simulation"]["rapid_collisions"][0].contains(key));
  CHECK(stage["simulation"]["holder_collisions"][0]["part"] == "holder");
}

TEST_CASE("result.json groups process findings and names what is left at a near miss",
          "[unit][json]") {
  const Json simulation = json_of(sample_result(Outcome::failed))["stages"][1]["simulation"];
  CHECK(simulation["rapid_collisions"].size() == 2);
  CHECK(simulation["holder_collisions"].size() == 1);
  const Json& findings = simulation["findings"];
  // Two rapids far apart, the holder, a run of two moves without spindle, a near miss.
  REQUIRE(findings.size() == 5);
  const Json& run = findings[3];
  CHECK(run["kind"] == "spindle_stopped");
  CHECK(run["count"] == 2);
  CHECK(run["first_line"] == 1611);
  CHECK(run["last_line"] == 1612);
  CHECK(run["line"] == 1612);
  CHECK(run["depth_mm"] == 0.5);
  CHECK(run["fails"] == true);
  const Json& near = findings[4];
  CHECK(near["kind"] == "near_miss");
  CHECK(near["fails"] == false);
  CHECK(near["distance_mm"] == 0.75);
  CHECK_FALSE(near.contains("depth_mm"));
  CHECK(near["against"] == "clamp");
  CHECK(simulation["removal"]["volume_mm3"] == 104'498.5);
}

TEST_CASE("result.json carries the values digit for digit", "[unit][json]") {
  RunResult result = sample_result(Outcome::passed);
  result.stages[2].ran->deviation->mean_mm = 0.1 + 0.2;
  result.stages[2].ran->deviation->gouges[0].place.u = 1.0 / 3.0;
  const Json root = json_of(result);
  const Json& deviation = root["stages"][2]["deviation"];
  CHECK(deviation["mean_mm"].get<double>() == 0.1 + 0.2);
  CHECK(deviation["gouges"][0]["u"].get<double>() == 1.0 / 3.0);
  CHECK(deviation["gouge_mm"]["high"] == result.stages[2].ran->deviation->gouge_mm.high);
  CHECK(deviation["gouges"][0]["stage"] == "finish");
  CHECK(deviation["histogram"]["edges_mm"].size() == deviation["histogram"]["area_mm2"].size() + 1);
  CHECK(root["surface"]["bbox_mm"][1][2] == 11.6);
  CHECK(root["stages"][0]["toolpath"]["moves"] == result.stages[0].ran->path->moves.size());
  CHECK(root["stages"][0]["gate"] ==
        Json{{"gouge_mm", 0.05}, {"uncut_mm", 1.0}, {"coverage", 0.99}});
}

TEST_CASE("a stage that was not run has no measured part", "[unit][json]") {
  const Json root = json_of(sample_result(Outcome::failed));
  CHECK(root["verdict"] == "fail");
  const Json& stage = root["stages"][2];
  CHECK(stage["verdict"] == "not_run");
  CHECK(stage["reasons"].size() == 1);
  for (const char* key : {"toolpath", "simulation", "deviation"}) CHECK_FALSE(stage.contains(key));
}

TEST_CASE("the files that were read stand with their checksums", "[unit][json]") {
  RunResult result = sample_result(Outcome::passed);
  result.inputs = {{"program", "a\x01.ngc", 12, std::string(64, '5')}};
  const Json inputs = json_of(result)["inputs"];
  REQUIRE(inputs.size() == 1);
  CHECK(keys_of(inputs[0]) == std::vector<std::string>{"role", "file", "bytes", "sha256"});
  CHECK(inputs[0]["role"] == "program");
  CHECK(inputs[0]["file"] == "a\xEF\xBF\xBD.ngc");
  CHECK(inputs[0]["bytes"] == 12);
  CHECK(inputs[0]["sha256"] == std::string(64, '5'));
}

TEST_CASE("a program stands in the place of a strategy", "[unit][json]") {
  RunResult result = sample_result(Outcome::passed);
  result.stages[0].strategy.clear();
  result.stages[0].program = "theirs.ngc";
  result.stages[0].limits = {};
  const Json root = json_of(result);
  const Json& stage = root["stages"][0];
  CHECK(stage["program"] == "theirs.ngc");
  CHECK_FALSE(stage.contains("strategy"));
  CHECK(stage["gate"].empty());
}

TEST_CASE("what is not a number is refused, never written", "[unit][json]") {
  RunResult result = sample_result(Outcome::passed);
  result.stages[1].ran->deviation->p50_mm = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(json_text_of(result), ContainsSubstring("deviation.p50_mm"));
  result = sample_result(Outcome::passed);
  result.stages[1].ran->deviation->uncut_mm.high = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(json_text_of(result), ContainsSubstring("deviation.uncut_mm"));
}

TEST_CASE("the same result gives the same bytes, in the contract's order", "[unit][json]") {
  const std::string text = json_text_of(sample_result(Outcome::indeterminate));
  CHECK(text == json_text_of(sample_result(Outcome::indeterminate)));
  CHECK(keys_of(Json::parse(text)) ==
        std::vector<std::string>{"schema", "job", "version", "created", "threads", "verdict",
                                 "inputs", "stock", "surface", "programs", "stages", "assumptions",
                                 "process_limits"});
}

TEST_CASE("what the command line set is kept as it was said", "[unit][json]") {
  RunResult result = sample_result(Outcome::passed);
  CHECK_FALSE(json_of(result).contains("overrides"));
  result.overrides = {"surface.transform.scale=0.5", "stage.finish.step=0.2"};
  CHECK(json_of(result)["overrides"] == Json(result.overrides));
  std::istringstream in(json_text_of(result));
  CHECK(record::read_result_json(in, "result.json").overrides == result.overrides);
}

TEST_CASE("fixtures and rotary axes are read as they are written", "[unit][json][schema]") {
  RunResult result = sample_result(Outcome::passed, 3);
  const auto limits_of = [&result] {
    std::istringstream in(json_text_of(result));
    return record::read_result_json(in, "result.json").process_limits.value();
  };
  CHECK_FALSE(limits_of().fixtures.has_value());
  constexpr double kNone = std::numeric_limits<double>::infinity();
  record::ProcessLimits& stated = result.process_limits;
  stated.fixtures = {{"vise", "a/vise.stl", {1, 2.5, -3}, {}, {}},
                     {"table", "table.stl", {}, "second", "none"}};
  stated.rotary_axes = {{"B", true, {0, 1, 0}, {0, 0, 150}, -kNone, 110},
                        {"C", false, {0, 0, 1}, {10, 20, 0}, -360, kNone}};
  const record::ProcessLimits read = limits_of();
  CHECK(read.fixtures == stated.fixtures);
  REQUIRE(read.rotary_axes->size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const record::RotaryAxis &was = (*stated.rotary_axes)[i], &is = (*read.rotary_axes)[i];
    CHECK(is.word == was.word);
    CHECK(is.lies_as(was));
    CHECK(is.low_deg == was.low_deg);
    CHECK(is.high_deg == was.high_deg);
  }
  const Json schema = Json::parse(result_schema());
  require_described(schema, schema, json_of(result), "");
}

TEST_CASE("names from files stay text", "[unit][json]") {
  RunResult result = sample_result(Outcome::passed);
  result.job = "a \"job\"\\ <script>\x02\xFF";
  CHECK(json_of(result)["job"] == "a \"job\"\\ <script>\uFFFD\uFFFD");
}

TEST_CASE("the schema describes every key that is written", "[unit][json][schema]") {
  const Json schema = Json::parse(result_schema());
  for (const Outcome outcome : {Outcome::passed, Outcome::failed, Outcome::indeterminate})
    require_described(schema, schema, json_of(sample_result(outcome, 3)), "");
}

TEST_CASE("stock from a mesh and from an earlier run", "[unit][json][schema][stock]") {
  const Json schema = Json::parse(result_schema());
  const auto mesh = std::make_shared<const model::TriangleMesh>(
      tests::block_between({-45, -40, -20}, {45, 40, 10}));
  RunResult result = sample_result(Outcome::passed);
  result.raw_stock = model::MeshStock{mesh, "casting.stl", 0};
  Json stock = json_of(result)["stock"];
  CHECK(keys_of(stock) == std::vector<std::string>{"shape", "file", "triangles", "corner_mm",
                                                   "size_mm", "volume_mm3"});
  CHECK(stock["shape"] == "mesh");
  CHECK(stock["file"] == "casting.stl");
  CHECK(stock["triangles"] == 12);
  CHECK(stock["size_mm"] == Json::array({90.0, 80.0, 30.0}));
  CHECK(stock["volume_mm3"].get<double>() == Approx(216000));
  require_described(schema, schema, json_of(result), "");
  result.raw_stock = model::MeshStock{mesh, "rough/stock.vdb", 0.1};
  stock = json_of(result)["stock"];
  CHECK(stock["shape"] == "vdb");
  CHECK(stock["voxel_mm"] == 0.1);
  require_described(schema, schema, json_of(result), "");
}
