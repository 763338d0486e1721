#include "reports/page/page_data.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/page/findings_data.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using nlohmann::json;

namespace {

json json_of(const RunResult& result) {
  return json::parse(page::page_data(result).json);
}

RunResult with_paths(RunResult result) {
  for (StageResult& stage : result.stages)
    if (stage.ran) stage.ran->path_view = page::path_view(*stage.ran->path, {}, {5000});
  return result;
}

}  // namespace

TEST_CASE("the page's data are the same bytes for the same result", "[unit][page]") {
  const page::PageData a = page::page_data(with_paths(sample_result(Outcome::failed, 9)));
  const page::PageData b = page::page_data(with_paths(sample_result(Outcome::failed, 9)));
  CHECK(a.json == b.json);
  CHECK(a.blob == b.blob);
}

TEST_CASE("the page's data hold what the result holds", "[unit][page]") {
  const RunResult result = with_paths(sample_result(Outcome::failed, 9));
  const json data = json_of(result);
  CHECK(data["format"] == "limitgauge.page/1");
  CHECK(data["verdict"] == "fail");
  REQUIRE(data["stages"].size() == 3);
  // All stages measure at the same places.
  REQUIRE(data["surfaces"].size() == 1);
  CHECK(data["surfaces"][0]["patches"].size() == 30);
  CHECK(data["surfaces"][0]["position"]["block"]["count"] == 3 * 30 * 81);
  const json& stage = data["stages"][1];
  const verifier::StageDeviation& d = *result.stages[1].ran->deviation;
  CHECK(stage["gouges_total"] == d.gouges.size());
  CHECK(stage["gouges"][0]["id"] == "G1");
  CHECK(stage["gouges"][0]["depth_mm"] == d.gouges[0].depth_mm);
  CHECK(stage["gouges"][0]["line"] == d.gouges[0].line);
  CHECK(stage["uncuts"].size() == d.uncuts.size());
  // Two rapids, the holder, two moves with the spindle at rest in one, a near miss last.
  CHECK(stage["process"].size() == 5);
  CHECK(stage["process"][0]["id"] == "P1");
  CHECK(stage["process"][0]["kind"] == "holder_in_stock");
  CHECK(stage["process"][4]["kind"] == "near_miss");
  CHECK(stage["process"][4]["fails"] == false);
  CHECK(stage["field"]["deviation_mm"]["count"] == 30 * 81);
  CHECK(stage["path"]["rate_mm3_min"] == nullptr);
  CHECK(stage["path"]["moves"] == result.stages[1].ran->path->moves.size());
  CHECK(stage["percentiles"]["p99_mm"] == d.p99_mm);
  const json& left = data["stages"][2];
  CHECK(left["ran"] == false);
  CHECK(left["field"] == nullptr);
  CHECK(left["path"] == nullptr);
  CHECK(left["gouges"].empty());
}

TEST_CASE("a finding's normal is that of the surface there", "[unit][page]") {
  const RunResult result = sample_result(Outcome::failed, 41);
  const verifier::Finding& f = result.stages[1].ran->deviation->gouges[0];
  const json normal = json_of(result)["stages"][1]["gouges"][0]["normal"];
  // The sample result's findings are at samples: the same normal, digit for digit.
  const auto& samples = result.stages[1].ran->deviation->field.samples;
  const auto at = std::find_if(samples.begin(), samples.end(),
                               [&](const auto& s) { return s.place.point == f.place.point; });
  REQUIRE(at != samples.end());
  for (int axis = 0; axis < 3; ++axis) CHECK(normal[axis] == at->normal[axis]);
}

namespace {

/// A tetrahedron of 10 mm beside the part.
model::Fixture clamp(double x_mm) {
  return {"clamp", "clamp.stl",
          std::make_shared<const model::TriangleMesh>(
              model::TriangleMesh{{{x_mm, 0, 0}, {x_mm + 10, 0, 0}, {x_mm, 10, 0}, {x_mm, 0, 10}},
                                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}})};
}

}  // namespace

TEST_CASE("fixtures stand in the part's frame, the same one once for all stages", "[unit][page]") {
  RunResult result = sample_result(Outcome::failed, 5);
  StageResult& turned = result.stages[0];
  // From the part's frame: a quarter turn about Z, so that x there is -y here.
  turned.setup.from_part.rows = {model::Vec3{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  turned.ran->fixtures = {clamp(50)};
  turned.ran->moving_fixtures = {"chuck"};
  result.stages[1].ran->fixtures = {clamp(50), clamp(-70), clamp(50)};
  const json data = json_of(result);
  REQUIRE(data["fixtures"].size() == 3);
  CHECK(data["stages"][0]["fixtures"] == json{0});
  CHECK(data["stages"][0]["moving_fixtures"] == json{"chuck"});
  CHECK(data["stages"][1]["fixtures"] == json{1, 2, 1});
  CHECK(data["stages"][1]["moving_fixtures"].empty());
  CHECK(data["stages"][2]["fixtures"].empty());
  const json& first = data["fixtures"][0];
  CHECK(first["name"] == "clamp");
  CHECK(first["file_triangles"] == 4);
  CHECK(first["triangle"]["count"] == 12);
  CHECK(first["position"]["block"]["count"] == 12);
}

TEST_CASE("lists of findings are cut, and say of how many", "[unit][page]") {
  RunResult result = sample_result(Outcome::failed, 5);
  auto& gouges = result.stages[1].ran->deviation->gouges;
  gouges.resize(1234, gouges.front());
  const json stage = json_of(result)["stages"][1];
  CHECK(stage["gouges"].size() == page::kMostFindings);
  CHECK(stage["gouges_total"] == 1234);
}

TEST_CASE("nothing from a file leaves the page's data", "[unit][page]") {
  RunResult result = with_paths(sample_result(Outcome::failed, 5));
  const std::string hostile = "</script><!--<script>alert(1)</script>\xff\x01\"\\\xe2\x80\xa8";
  result.job = result.created = result.version = hostile;
  for (StageResult& stage : result.stages) {
    stage.name = stage.tool = stage.strategy = stage.program = stage.program_part = hostile;
    if (!stage.ran) continue;
    for (auto& f : stage.ran->process) f.part = f.against = hostile;
    for (auto& f : stage.ran->deviation->gouges) f.body = hostile;
    std::string program;
    for (int i = 0; i < 2000; ++i) program += "(" + hostile + ")\n";
    stage.ran->program_text = std::make_shared<const std::string>(program);
  }
  const page::PageData data = page::page_data(result);
  CHECK(data.json.find('<') == std::string::npos);
  CHECK(data.blob.find_first_not_of(
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=") ==
        std::string::npos);
  const json parsed = json::parse(data.json);
  const std::string shown =
      "</script><!--<script>alert(1)</script>\xef\xbf\xbd\xef\xbf\xbd\"\\\xe2\x80\xa8";
  CHECK(parsed["job"] == shown);
  CHECK(parsed["stages"][1]["path_source"] == "program " + shown + ", " + shown);
  std::ostringstream out;
  page::write_page_script(result, out);
  const std::string text = out.str();
  std::size_t ends = 0;
  const std::size_t script = text.rfind("<script>");
  for (std::size_t at = 0; (at = text.find("</script", at)) < script; ++at) ++ends;
  CHECK(ends == 2);
}

TEST_CASE("a figure that is no number leaves readable data", "[unit][page]") {
  RunResult result = sample_result(Outcome::passed, 5);
  result.stages[0].ran->deviation->mean_mm = NAN;
  result.stages[0].ran->deviation->gouge_mm.high = NAN;
  CHECK(json_of(result)["stages"][0]["gouge_mm"]["high"] == nullptr);
}

TEST_CASE("a result without fields or paths still has data", "[unit][page]") {
  RunResult result = sample_result(Outcome::passed, 5);
  for (StageResult& stage : result.stages) stage.ran->deviation->field = {};
  const json data = json_of(result);
  CHECK(data["surfaces"].empty());
  CHECK(data["stages"][0]["field"] == nullptr);
  CHECK(data["stages"][0]["gouges"][0]["normal"] == nullptr);
}
