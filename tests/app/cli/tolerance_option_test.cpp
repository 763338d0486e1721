#include "app/verify/tolerance_option.h"

#include <vector>

#include "app/cli/usage_error.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

using Options = std::vector<std::string>;

JobTool ball(const char* id, std::optional<std::uint32_t> number) {
  JobTool tool;
  tool.cutter = {id, model::CutterType::ball, 3, 0, 0, 20, {}, {}};
  tool.number = number;
  return tool;
}

std::string error_with(const Options& options, const std::vector<JobTool>& tools) {
  try {
    tolerances_of(options, tools);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("options of tolerances are half widths in mm", "[unit]") {
  const std::vector<JobTool> tools{ball("a", 1), ball("b", 22)};
  const model::Tolerances got =
      tolerances_of(Options{"zero=0.001,0.002,0", "22:radius=0.01,length=0.005", "path=0.003",
                            "runout=0.004", "positioning=0.001,0,0.002"},
                    tools);
  CHECK(got.zero_mm[1].low == -0.002);
  CHECK(got.zero_mm[1].high == 0.002);
  REQUIRE(got.tools.size() == 1);
  CHECK(got.tools.at("b").radius_mm.high == 0.01);
  CHECK(got.tools.at("b").length_mm.low == -0.005);
  CHECK(got.path_mm == 0.003);
  CHECK(got.runout_mm == 0.004);
  CHECK(got.positioning_mm.z == 0.002);
}

TEST_CASE("an only tool needs no number", "[unit]") {
  const std::vector<JobTool> tools{ball("a", std::nullopt)};
  CHECK(tolerances_of(Options{"radius=0.01"}, tools).tools.at("a").radius_mm.high == 0.01);
}

TEST_CASE("options of tolerances that say nothing clear are refused", "[unit]") {
  const std::vector<JobTool> two{ball("a", 1), ball("b", 2)};
  CHECK_THAT(error_with({"radius=0.01"}, two), ContainsSubstring("there are several tools"));
  CHECK_THAT(error_with({"3:radius=0.01"}, two), ContainsSubstring("has the number \"3\""));
  CHECK_THAT(error_with({"1:width=0.01"}, two), ContainsSubstring("no figure \"width\""));
  CHECK_THAT(error_with({"1:radius"}, two), ContainsSubstring("no value"));
  CHECK_THAT(error_with({"1:radius=-0.01"}, two), ContainsSubstring("no half width"));
  CHECK_THAT(error_with({"1:radius=nan"}, two), ContainsSubstring("no half width"));
  CHECK_THAT(error_with({"zero=0.01"}, two), ContainsSubstring("zero="));
  CHECK_THAT(error_with({"zero=0,0,-0.01"}, two), ContainsSubstring("not negative"));
  CHECK_THAT(error_with({"path"}, two), ContainsSubstring("no value"));
  CHECK_THAT(error_with({"1:corner_radius=0.1"}, two), ContainsSubstring("--tolerance"));
  CHECK_THAT(error_with({"runout=4"}, two), ContainsSubstring("--tolerance"));
}

TEST_CASE("no tolerance is stated twice", "[unit]") {
  const std::vector<JobTool> two{ball("a", 1), ball("b", 2)};
  CHECK_THAT(error_with({"path=0.1", "path=0.2"}, two), ContainsSubstring("\"path\" a second"));
  CHECK_THAT(error_with({"1:radius=0.01", "1:length=0.1,radius=0.02"}, two),
             ContainsSubstring("\"a.radius\" a second"));
  CHECK(error_with({"1:radius=0.01", "2:radius=0.01"}, two) == "no error");
}

}  // namespace limitgauge::app
