#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

TEST_CASE("the aircraft passes its three stages within a micrometre", "[slow][run]") {
  const Scratch scratch;
  const Outcome outcome = limitgauge(
      scratch, {"run", fixture("jobs/aircraft.toml"), "-o", "out", "--quiet", "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const auto result = nlohmann::json::parse(read_text(scratch / "out/result.json"));
  REQUIRE(result["stages"].size() == 3);
  for (const auto& stage : result["stages"]) {
    CHECK(stage["simulation"]["rapid_collisions"].empty());
    CHECK(stage["simulation"]["holder_collisions"].empty());
    CHECK(stage["simulation"]["peak_memory_bytes"] < 6.0 * 1024 * 1024 * 1024);
  }
  // Rough leaves its allowance of 0.2 mm less its tolerance of 0.05 mm everywhere.
  CHECK(result["stages"][0]["deviation"]["gouge_mm"]["high"] <= 0.05);
  const auto& finish = result["stages"][2]["deviation"];
  CHECK(finish["coverage"] >= 0.995);
  for (const char* figure : {"gouge_mm", "uncut_mm"}) {
    const double low = finish[figure]["low"], high = finish[figure]["high"];
    CHECK(high <= 0.01);
    // The interval asked for is a tenth of the gate; the sum of two roundings lies far below 1 nm.
    CHECK(high - low <= 0.001 + 1e-9);
  }
}

}  // namespace
}  // namespace limitgauge::e2e
