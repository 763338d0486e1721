// A stage that was cut with the part turned over: files, figures and words are in the part's frame.
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/picture/tool_side.h"
#include "reports/record/stock_record.h"
#include "reports/run/report.h"
#include "reports/vtk/toolpath_reader.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using nlohmann::json;

namespace {

model::Setup turned_over() {
  model::Setup setup{"back & forth", model::turn_about({1, 0, 0}, 180)};
  setup.from_part.shift_mm = {0, 0, 10};
  return setup;
}

/// The sample with its last stage in a second setup.
RunResult in_two_setups() {
  RunResult result = sample_result(Outcome::passed, 5);
  result.setups = {{"front", {}}, turned_over()};
  for (StageResult& stage : result.stages) stage.setup = result.setups[0];
  result.stages.back().setup = result.setups[1];
  for (StageResult& stage : result.stages)
    if (stage.ran) stage.ran->stock_to_part = stage.setup.from_part.inverse();
  return result;
}

json as_json(const RunResult& result) {
  std::ostringstream out;
  write_result_json(result, out);
  return json::parse(out.str());
}

}  // namespace

TEST_CASE("result.json says how the part lay for each stage", "[unit][setups]") {
  const json result = as_json(in_two_setups());
  REQUIRE(result["setups"].size() == 2);
  CHECK(result["setups"][1]["name"] == "back & forth");
  CHECK(result["setups"][1]["rotation"] == json({{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}));
  CHECK(result["setups"][1]["origin_mm"] == json({0, 0, 10}));
  CHECK(result["setups"][1]["tool_axis"] == json({0, 0, -1}));
  CHECK(result["stages"].back()["setup"] == "back & forth");
  const json plain = as_json(sample_result(Outcome::passed, 5));
  CHECK_FALSE(plain.contains("setups"));
  CHECK_FALSE(plain["stages"][0].contains("setup"));
}

TEST_CASE("a stock record knows how cutters stood", "[unit][setups]") {
  std::ostringstream out;
  write_result_json(in_two_setups(), out);
  std::istringstream in(out.str());
  const record::StockRecord read = record::read_stock_record(in, "result.json");
  CHECK(read.stages.front().from_part == model::Pose{});
  CHECK(read.stages.back().from_part == turned_over().from_part);
  json broken = json::parse(out.str());
  broken["setups"][1]["rotation"][2] = {0, 0, 1};
  std::istringstream mirrored(broken.dump());
  CHECK_THROWS_AS(record::read_stock_record(mirrored, "result.json"), model::InputError);
  broken["stages"].back()["setup"] = "nowhere";
  std::istringstream unknown(broken.dump());
  CHECK_THROWS_AS(record::read_stock_record(unknown, "result.json"), model::InputError);
}

TEST_CASE("a turned stage's path and stock are written where they are in the part",
          "[unit][setups][files]") {
  const tests::TemporaryFolder folder;
  StageResult stage = in_two_setups().stages.back();
  const model::Pose to_part = stage.setup.from_part.inverse();
  // A block of the part's -20 to 10 in Z lies from 0 to 30 in the setup.
  const simulator::StockModel raw(model::BoxStock{{-45, -40, 0}, {90, 80, 30}}, 2.0,
                                  std::size_t(1) << 30);
  stage.ran->stock = raw;
  const StageFiles files = write_stage_files(stage, folder.path(), {.pictures = false});
  const model::Toolpath path = read_toolpath_vtp(folder.path() / stage.name / "toolpath.vtp").path;
  REQUIRE(path.moves.size() == stage.ran->path->moves.size());
  CHECK(path.start == to_part.point(stage.ran->path->start));
  CHECK(path.moves.back().to == to_part.point(stage.ran->path->moves.back().to));
  CHECK(path.moves.back().line == stage.ran->path->moves.back().line);
  REQUIRE(files.path_view);
  CHECK(files.path_view->start == path.start);
  CHECK_FALSE(files.pictures.stock_png.size());
}

TEST_CASE("words of where a tool comes from", "[unit][setups]") {
  CHECK(tool_side_words({"a", {}}) == "+Z");
  CHECK(tool_side_words(turned_over()) == "−Z");
  // Turned about X by a quarter, the part's +Y is up.
  CHECK(tool_side_words({"a", model::turn_about({1, 0, 0}, 90)}) == "+Y");
  CHECK(tool_side_words({"a", model::turn_about({0, 1, 0}, 90)}) == "−X");
  CHECK(tool_side_words({"a", model::turn_about({1, 0, 0}, 30)}) == "(0, 0.500, 0.866)");
}

TEST_CASE("the page lists the setups, escaped, and says where a stage's tool comes from",
          "[unit][setups][html]") {
  std::ostringstream out;
  write_html(in_two_setups(), out);
  const std::string page = out.str();
  CHECK_THAT(page, Catch::Contains("id=\"setups\""));
  CHECK_THAT(page, Catch::Contains("back &amp; forth"));
  CHECK_THAT(page, !Catch::Contains("back & forth<"));
  CHECK_THAT(page, Catch::Contains("the tool comes from −Z"));
  std::ostringstream plain;
  write_html(sample_result(Outcome::passed, 5), plain);
  CHECK_THAT(plain.str(), !Catch::Contains("id=\"setups\""));
}

TEST_CASE("a map is seen from the tool's side", "[unit][setups][picture]") {
  const StageResult stage = in_two_setups().stages.back();
  const ToolSide side(stage);
  const auto& seen = side.deviation().field.samples;
  const auto& known = stage.ran->deviation->field.samples;
  REQUIRE(seen.size() == known.size());
  for (std::size_t i = 0; i < seen.size(); i += 7)
    CHECK(seen[i].place.point == stage.setup.from_part.point(known[i].place.point));
}
