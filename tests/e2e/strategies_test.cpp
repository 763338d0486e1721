#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

nlohmann::json run_job(const Scratch& scratch, const std::string& job) {
  const Outcome outcome =
      limitgauge(scratch, {"run", fixture("jobs/" + job), "-o", "out", "--quiet", "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return nlohmann::json::parse(read_text(scratch / "out/result.json"));
}

TEST_CASE("strategies of any cutter pass their gates", "[slow][run]") {
  const std::string job = GENERATE("steep-shallow.toml", "bull-zigzag.toml", "taper-zigzag.toml");
  INFO(job);
  const Scratch scratch;
  const nlohmann::json result = run_job(scratch, job);
  CHECK(result["verdict"] == "pass");
  REQUIRE(result["stages"].size() == 2);
  for (const auto& stage : result["stages"]) {
    CHECK(stage["simulation"]["rapid_collisions"].empty());
    CHECK(stage["simulation"]["holder_collisions"].empty());
  }
  const auto& finish = result["stages"][1]["deviation"];
  // The path keeps the chord error of its mesh away whole: no gouge is left but that of the rough
  // stage before it, which keeps its allowance. The interval asked for is a tenth of the gate.
  CHECK(finish["gouge_mm"]["low"] == 0);
  CHECK(finish["gouge_mm"]["high"] <= 0.001);
  // A finish leaves something: cusps.
  CHECK(finish["uncut_mm"]["low"] > 0.002);
  CHECK(finish["coverage"] >= 0.99);
}

}  // namespace
}  // namespace limitgauge::e2e
