#include <nlohmann/json.hpp>

#include <algorithm>

#include "tests/e2e/memory/forecast.h"
#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

using nlohmann::json;

/// Parts on which toolpath engines go wrong. The verifier knows nothing of the engine: that the
/// gates pass proves that nothing is gouged and nothing in reach is left.
json torture(const std::string& name) {
  const Scratch scratch;
  const Outcome outcome = limitgauge(scratch, {"run", fixture("torture/" + name + ".toml"), "-o",
                                               "out", "--verbose", "--no-pictures"});
  INFO(name << "\n" << outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  check_forecast(outcome);
  json result = json::parse(read_text(scratch / "out/result.json"));
  for (const json& stage : result["stages"]) {
    CHECK(stage["simulation"]["rapid_collisions"].empty());
    CHECK(stage["simulation"]["holder_collisions"].empty());
    CHECK(stage["toolpath"]["sampling_intervals"].size() == result["surface"]["depths"].size());
  }
  return result;
}

const json& finish(const json& result) {
  return result["stages"].back()["deviation"];
}

TEST_CASE("a bowl tighter than the ball is cut as deep as the ball can go", "[slow][torture]") {
  const json result = torture("deep-bowl");
  // Below where a ball of 3 mm touches the bowl z = r²/4 on both sides, r = √5, z = 5/4: the ball
  // stands on a ring there and 1/4 mm remains over the lowest point.
  CHECK(finish(result)["unreachable_area_mm2"] > 5.0);
  CHECK(finish(result)["unavoidable_uncut_mm"] > 0.1);
}

TEST_CASE("a thin fin stands and both its sides are cut", "[slow][torture]") {
  torture("thin-fin");
}

TEST_CASE("a sharp ridge keeps its edge", "[slow][torture]") {
  torture("crease-ridge");
}

TEST_CASE("a vertex of valence twelve is cut", "[slow][torture]") {
  const json result = torture("star-12");
  CHECK(result["surface"]["extraordinary_vertices"] == 1);
}

TEST_CASE("a closed torus is cut to both its equators", "[slow][torture]") {
  const json result = torture("torus");
  CHECK(result["surface"]["boundary_edges"] == 0);
  // The lower half is out of reach from above: half of the surface, less what a ball touches of
  // the equators' surroundings within the contact tolerance.
  const double whole = finish(result)["surface_area_mm2"];
  CHECK(finish(result)["unreachable_area_mm2"] > 0.4 * whole);
}

TEST_CASE("a bore is cut down its wall", "[slow][torture]") {
  torture("bore-ring");
}

TEST_CASE("faces with five corners are cut", "[slow][torture]") {
  const json result = torture("n-gons");
  CHECK(result["surface"]["faces"] == 12);
  CHECK(result["surface"]["depths"].size() == 60);
}

TEST_CASE("patches whose depths differ by four are cut without cracks", "[slow][torture]") {
  const json result = torture("uneven-depths");
  const std::vector<int> depths = result["surface"]["depths"];
  const auto [least, largest] = std::minmax_element(depths.begin(), depths.end());
  CHECK(*largest - *least >= 4);
}

TEST_CASE("two thousand patches are cut", "[slow][torture]") {
  const json result = torture("egg-crate");
  CHECK(result["surface"]["depths"].size() == 2000);
}

}  // namespace
}  // namespace limitgauge::e2e
