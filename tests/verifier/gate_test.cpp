#include "tests/support/catch.h"
#include "verifier/verify.h"

namespace limitgauge::verifier {
namespace {

StageDeviation with(Interval gouge, Interval uncut, double coverage = 1) {
  StageDeviation d;
  d.gouge_mm = gouge;
  d.uncut_mm = uncut;
  d.coverage = coverage;
  return d;
}
const GateLimits kLimits{true, true, true, 0.01, 0.02, 0.99};

}  // namespace

TEST_CASE("conformance must be proven to pass, non-conformance to fail", "[unit]") {
  CHECK(decide(with({0, 0.01}, {0, 0.02}), kLimits).verdict == Verdict::pass);
  CHECK(decide(with({0.0101, 0.02}, {0, 0}), kLimits).verdict == Verdict::fail);
  CHECK(decide(with({0.0099, 0.0101}, {0, 0}), kLimits).verdict == Verdict::indeterminate);
  CHECK(decide(with({0, 0}, {0.019, 0.021}), kLimits).verdict == Verdict::indeterminate);
  CHECK(decide(with({0, 0}, {0.021, 0.03}), kLimits).verdict == Verdict::fail);
  CHECK(decide(with({0, 0}, {0, 0}, 0.98), kLimits).verdict == Verdict::fail);
}

TEST_CASE("a proven failure outweighs an open question", "[unit]") {
  CHECK(decide(with({0.0099, 0.0101}, {0.03, 0.04}), kLimits).verdict == Verdict::fail);
}

TEST_CASE("collisions fail a stage whatever its figures", "[unit]") {
  const std::vector<ProcessFault> none = {{"rapid", 0}, {"holder", 0}},
                                  two = {{"rapid", 0}, {"holder", 2}};
  CHECK(decide(with({0, 0}, {0, 0}), kLimits, none).verdict == Verdict::pass);
  CHECK(decide(with({0, 0}, {0, 0}), kLimits, two).verdict == Verdict::fail);
  const GateDecision unlimited = decide(with({0, 0}, {0, 0}), {}, two);
  CHECK(unlimited.verdict == Verdict::fail);
  CHECK(unlimited.reasons == std::vector<std::string>{"holder: 2 moves"});
}

TEST_CASE("figures without a limit cannot fail", "[unit]") {
  CHECK(decide(with({5, 6}, {7, 8}, 0), {}).verdict == Verdict::pass);
}

TEST_CASE("what is said of a certified interval is true to its digits", "[unit]") {
  const auto said = [](Interval gouge) {
    return decide(with(gouge, {0, 0}), kLimits).reasons.at(0);
  };
  CHECK_THAT(said({0, 0.000950011}), ContainsSubstring("between 0 µm and 0.9501 µm, limit 10 µm"));
  CHECK_THAT(said({0.00123456, 0.00234561}), ContainsSubstring("between 1.234 µm and 2.346 µm"));
  CHECK_THAT(said({0.0011, 0.007}), ContainsSubstring("between 1.1 µm and 7 µm"));
  CHECK_THAT(said({0, 1.1e-8}), ContainsSubstring("between 0 µm and 0.011 nm"));
  CHECK_THAT(said({1.23456, 2.34561}), ContainsSubstring("between 1.234 mm and 2.346 mm"));
}

TEST_CASE("material that stands beside removed space fails the uncut gate", "[unit]") {
  StageDeviation wall = with({0, 0}, {0.001, 0.002});
  wall.voxel_uncut_mm = 3;
  const GateDecision decision = decide(wall, kLimits);
  CHECK(decision.verdict == Verdict::fail);
  CHECK_THAT(decision.reasons.at(2), ContainsSubstring("material stands 3 mm"));
}

TEST_CASE("a hole that is deeper than wide fails the gouge gate, a corner does not", "[unit]") {
  StageDeviation hole = with({0.008, 0.009}, {0, 0});
  hole.voxel_gouge_mm = 1.2;
  const GateDecision decision = decide(hole, kLimits);
  CHECK(decision.verdict == Verdict::fail);
  CHECK_THAT(decision.reasons.at(1), ContainsSubstring("the stock lies 1.2 mm under"));
  StageDeviation corner = with({0.009, 0.0095}, {0, 0});
  corner.voxel_gouge_mm = 0.0115;
  CHECK(decide(corner, kLimits).verdict == Verdict::pass);
}

TEST_CASE("automatic resolution is a tenth of the tightest limit", "[unit]") {
  CHECK(automatic_resolution_mm(kLimits) == Approx(0.001));
  CHECK(automatic_resolution_mm({true, true, false, 0.05, 0.004, 0}) == Approx(0.0004));
  CHECK(automatic_resolution_mm({}) == Approx(0.001));
}

}  // namespace limitgauge::verifier
