#include <nlohmann/json.hpp>

#include "tests/e2e/memory/forecast.h"
#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

/// Runs a job of a rough and a finish stage and looks at its certified figures.
void check_job(const std::string& job) {
  const Scratch scratch;
  const Outcome outcome = limitgauge(
      scratch, {"run", fixture("jobs/" + job), "-o", "out", "--verbose", "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  check_forecast(outcome);
  const auto result = nlohmann::json::parse(read_text(scratch / "out/result.json"));
  REQUIRE(result["stages"].size() == 2);
  for (const auto& stage : result["stages"]) {
    CHECK(stage["verdict"] == "pass");
    CHECK(stage["simulation"]["rapid_collisions"].empty());
    CHECK(stage["simulation"]["holder_collisions"].empty());
  }
  const auto& finish = result["stages"][1]["deviation"];
  // The path keeps the chord error of its mesh away whole: nothing is gouged. The interval asked
  // for is a tenth of the gate's 0.02 mm; the sum of two roundings lies far below 1 nm.
  CHECK(finish["gouge_mm"]["low"] == 0);
  CHECK(finish["gouge_mm"]["high"] <= 0.002 + 1e-7);
  // A finish leaves something: cusps.
  CHECK(finish["uncut_mm"]["low"] > 0.002);
  CHECK(finish["coverage"] >= 0.99);
}

TEST_CASE("contours where it is steep and rows where it is flat pass their gates", "[slow][run]") {
  check_job("steep-shallow.toml");
}
TEST_CASE("rows of a bull-nosed cutter pass their gates", "[slow][run]") {
  check_job("bull-zigzag.toml");
}
TEST_CASE("rows of a tapered cutter pass their gates", "[slow][run]") {
  check_job("taper-zigzag.toml");
}

}  // namespace
}  // namespace limitgauge::e2e
