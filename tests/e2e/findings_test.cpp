#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

nlohmann::json run(const Scratch& scratch, const std::string& job, int expected_exit) {
  const Outcome outcome = limitgauge(scratch, {"run", fixture("findings/" + job + ".toml"), "-o",
                                               job, "--quiet", "--no-pictures"});
  INFO(job << ": " << outcome.errors << outcome.out);
  REQUIRE(outcome.exit_code == expected_exit);
  return nlohmann::json::parse(read_text(scratch / (job + "/result.json")))["stages"][0];
}

struct Planted {
  const char* job;
  const char* kind;
  int line;         ///< of the program, where the worst place is
  double depth_mm;  ///< as planted
  int exit_code = 1;
};

/// Contacts are found as lower bounds, as a rule within the tolerance of 0.01 mm.
constexpr double kTolerance_mm = 0.05;

}  // namespace

// Program lines and depths worked out by hand; a depth is the distance from the material's surface.
// Rows at z 0 run 5 mm under what the first level left and 10 mm under the raw top; each clears a
// strip 4 mm wide. Shank and holder are 8 mm over the tip: 2 mm deep. The stopped rows are judged
// together: 5 mm deep in the second. Above flutes of 6 mm stand 4 mm, of which the middle is 2 mm
// from air. The clamp's edge passes the cutter's axis: 4 mm, its radius. The travel ends 5 mm
// before the rows do, and the way from the program's start to the first of them, line 5, goes there
// already.
TEST_CASE("every kind of process finding is found where it was planted, and its twin is clean",
          "[e2e][process]") {
  const Planted planted = GENERATE(Planted{"rapid-through-stock", "rapid_through_stock", 23, 4},
                                   Planted{"shank-in-stock", "shank_in_stock", 7, 2},
                                   Planted{"holder-in-stock", "holder_in_stock", 18, 2},
                                   Planted{"fixture-touched", "fixture_touched", 8, 4},
                                   Planted{"spindle-stopped", "spindle_stopped", 28, 5},
                                   Planted{"feed-missing", "feed_missing", 7, 5},
                                   Planted{"below-flutes", "below_flutes", 7, 2},
                                   Planted{"steep-descent", "steep_descent", 7, 5},
                                   Planted{"beyond-travel", "beyond_travel", 5, 5},
                                   Planted{"near-miss", "near_miss", 29, -1, 0});
  const Scratch scratch;
  const auto stage = run(scratch, planted.job, planted.exit_code);
  // The shape is right: it is the process alone that fails.
  CHECK(stage["deviation"]["gouge_mm"]["high"] <= 0.01);
  CHECK(stage["deviation"]["uncut_mm"]["high"] <= 0.01);
  const auto& findings = stage["simulation"]["findings"];
  REQUIRE_FALSE(findings.empty());
  double deepest = -1e9;
  nlohmann::json worst;
  for (const auto& finding : findings) {
    INFO(finding.dump());
    CHECK(finding["kind"] == planted.kind);
    CHECK(finding["fails"] == (planted.exit_code == 1));
    const bool near = finding.contains("distance_mm");
    const double depth =
        near ? -finding["distance_mm"].get<double>() : finding["depth_mm"].get<double>();
    // Rows alike are as deep but for rounding: the first of them.
    if (depth > deepest + 1e-9) deepest = depth, worst = finding;
  }
  INFO(worst.dump());
  CHECK(worst["line"] == planted.line);
  CHECK(deepest <= planted.depth_mm + 1e-6);
  CHECK(deepest >= planted.depth_mm - kTolerance_mm);

  const auto clean = run(scratch, std::string(planted.job) + "-clean", 0);
  CHECK(clean["simulation"]["findings"].empty());
  CHECK(clean["verdict"] == "pass");
}

}  // namespace limitgauge::e2e
