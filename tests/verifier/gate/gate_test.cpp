#include "tests/support/catch.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {
namespace {

StageDeviation with(Interval gouge, Interval uncut, double coverage = 1) {
  StageDeviation d;
  d.gouge_mm = gouge;
  d.uncut_mm = uncut;
  d.coverage = coverage;
  return d;
}

Finding finding(const model::Vec3& at, double depth_mm, std::uint32_t line) {
  Finding f;
  f.place.point = at;
  f.depth_mm = depth_mm;
  f.line = line;
  return f;
}

/// A surface whose parts were proven to be in reach, out of it, or neither, mm².
StageDeviation reach(double reachable, double unreachable, double undecided) {
  StageDeviation d = with({0, 0}, {0, 0});
  d.proven_reach = {reachable, unreachable, undecided};
  d.surface_area_mm2 = reachable + unreachable + undecided;
  return d;
}

std::string all(const GateDecision& decision) {
  std::string text;
  for (const std::string& reason : decision.reasons) text += reason + "\n";
  return text;
}

using Catch::Matchers::EndsWith;

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

TEST_CASE("reasons of figures that pass are told from those that do not", "[unit]") {
  const std::vector<std::string> good = decide(with({0, 0.01}, {0, 0.02}), kLimits).reasons;
  CHECK(good.size() == 3);
  for (const std::string& reason : good) CHECK(tells_a_pass(reason));
  const auto fails = [](const StageDeviation& d, std::size_t reason) {
    return !tells_a_pass(decide(d, kLimits).reasons.at(reason));
  };
  CHECK(fails(with({0.0101, 0.02}, {0, 0}), 0));
  CHECK(fails(with({0.0099, 0.0101}, {0, 0}), 0));
  CHECK(fails(with({0, 0}, {0.021, 0.03}), 1));
  CHECK(fails(with({0, 0}, {0, 0}, 0.98), 2));
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

TEST_CASE("a figure that does not pass names depth, place and program line", "[unit]") {
  const Finding shallow = finding({0, 0, 0}, 0.001, 7), deep = finding({1, -2, 3.5}, 0.0123, 120);
  StageDeviation d = with({0.0123, 0.0125}, {0, 0});
  d.gouges = {shallow, deep};
  CHECK_THAT(decide(d, kLimits).reasons.at(0),
             ContainsSubstring("; deepest 12.3 µm at (1.000, -2.000, 3.500) mm, program line 120"));
  d.gouge_mm = {0.0099, 0.0101};
  CHECK_THAT(decide(d, kLimits).reasons.at(0), ContainsSubstring("program line 120"));
  d.gouge_mm = {0.009, 0.01};
  CHECK(decide(d, kLimits).reasons.at(0).find("program line") == std::string::npos);
}

TEST_CASE("a line of an earlier program comes with the stage whose it is", "[unit]") {
  StageDeviation d = with({0.02, 0.03}, {0.1, 0.2});
  d.gouges = {finding({0, 0, 0}, 0.02, 12)};
  d.uncuts = {finding({0, 0, 0}, 0.1, 34)};
  d.uncuts[0].stage = 1;
  const std::vector<std::string> stages = {"rough", "finish"};
  const GateDecision decision = decide(d, kLimits, {}, stages);
  CHECK_THAT(decision.reasons.at(0), EndsWith("program line 12 of stage rough"));
  CHECK_THAT(decision.reasons.at(1), EndsWith("program line 34"));
}

TEST_CASE("a leftover that the raw stock ends has no program line", "[unit]") {
  StageDeviation d = with({0, 0}, {0.1, 0.2});
  d.uncuts = {finding({0, 0, 0}, 0.1, 0)};
  d.uncuts[0].raw_stock = true;
  CHECK_THAT(decide(d, kLimits).reasons.at(1), EndsWith("a face of the raw stock"));
}

TEST_CASE("rays into the simulated stock gate nothing: both instruments measure runs", "[unit]") {
  StageDeviation d = with({0.008, 0.009}, {0.001, 0.002});
  d.voxel_gouge_mm = 1.2, d.voxel_uncut_mm = 3;
  CHECK(decide(d, kLimits).verdict == Verdict::pass);
}

TEST_CASE("no reason prints a figure across the limit that it speaks of", "[unit]") {
  // Four digits would show each of these as the limit itself.
  CHECK_THAT(all(decide(with({0.004, 0.00999996}, {0, 0}), kLimits)),
             ContainsSubstring("between 4 µm and 9.99996 µm, limit 10 µm: within"));
  CHECK_THAT(all(decide(with({0.01000004, 0.012}, {0, 0}), kLimits)),
             ContainsSubstring("between 10.00004 µm and 12 µm, limit 10 µm: beyond"));
  CHECK_THAT(all(decide(with({0.004, 0.01}, {0, 0}), kLimits)),
             ContainsSubstring("between 4 µm and 10 µm, limit 10 µm: within"));
  CHECK_THAT(
      all(decide(with({0, 0}, {0, 0}, 0.989999), kLimits)),
      ContainsSubstring("coverage 0.9899 of the reachable area, least accepted 0.9900: too"));
  StageDeviation d = with({0.01000004, 0.012}, {0, 0});
  d.gouges = {finding({1, 2, 3}, 0.01000004, 12)};
  CHECK_THAT(all(decide(d, kLimits)), ContainsSubstring("deepest 10.00004 µm at"));
}

TEST_CASE("what cannot be reached is gated by its share of the surface", "[unit]") {
  GateLimits limits;
  limits.has_unreachable = true, limits.unreachable = 0.05;
  CHECK(decide(reach(952, 40, 8), limits).verdict == Verdict::pass);
  CHECK(decide(reach(950, 50, 0), limits).verdict == Verdict::pass);
  CHECK(decide(reach(951, 40, 12), limits).verdict == Verdict::indeterminate);
  const GateDecision decision = decide(reach(940, 51, 9), limits);
  CHECK(decision.verdict == Verdict::fail);
  CHECK(decision.reasons.at(0) ==
        "unreachable certified between 51 mm² and 60 mm² (5.1 % to 6 %), limit 5 %: beyond the "
        "limit");
}

TEST_CASE("what cannot be reached is gated by its area", "[unit]") {
  GateLimits limits;
  limits.has_unreachable = true, limits.unreachable_is_share = false, limits.unreachable = 12.5;
  CHECK(decide(reach(987.5, 10, 2.5), limits).verdict == Verdict::pass);
  CHECK(decide(reach(987, 12, 1), limits).verdict == Verdict::indeterminate);
  const GateDecision decision = decide(reach(987, 13, 0), limits);
  CHECK(decision.verdict == Verdict::fail);
  CHECK_THAT(decision.reasons.at(0), ContainsSubstring("limit 12.5 mm²"));
}

TEST_CASE("limits of zero hold where only rounding is, and no further", "[unit]") {
  GateLimits limits;
  limits.has_unreachable = limits.has_unavoidable = true;
  StageDeviation d = reach(1000, 0, 5.8e-21);
  d.unavoidable_uncut_mm = {0, 6.4e-8};
  CHECK(decide(d, limits).verdict == Verdict::pass);
  CHECK(decide(reach(1000, 0, 2e-9), limits).verdict == Verdict::indeterminate);
  CHECK(decide(reach(1000, 2e-9, 0), limits).verdict == Verdict::fail);
  d.unavoidable_uncut_mm = {0, 2e-6};
  CHECK(decide(d, limits).verdict == Verdict::indeterminate);
}

TEST_CASE("the unavoidable uncut is gated, and the place out of reach named", "[unit]") {
  GateLimits limits;
  limits.has_unavoidable = true, limits.unavoidable_mm = 0.3;
  StageDeviation d = reach(900, 100, 0);
  d.unavoidable_uncut_mm = {0.2, 0.3};
  CHECK(decide(d, limits).verdict == Verdict::pass);
  d.unavoidable_uncut_mm = {0.2, 0.31};
  CHECK(decide(d, limits).verdict == Verdict::indeterminate);
  d.unavoidable_uncut_mm = {0.31, 0.32};
  DeviationField::Sample near, far;
  near.reachable = far.reachable = false;
  near.deviation_mm = 0.25F, far.deviation_mm = 0.5F;
  far.place.point = {4, 5, 6}, far.line = 9;
  d.field.samples = {near, far};
  const GateDecision decision = decide(d, limits);
  CHECK(decision.verdict == Verdict::fail);
  CHECK_THAT(decision.reasons.at(0),
             ContainsSubstring("unavoidable uncut certified between 0.31 mm and 0.32 mm, limit "
                               "0.3 mm: beyond the limit"));
  CHECK_THAT(decision.reasons.at(0), ContainsSubstring("(4.000, 5.000, 6.000) mm, program line 9"));
}

TEST_CASE("nothing in reach fails by name, gates or not", "[unit]") {
  const StageDeviation none = reach(0, 100, 0);
  for (const GateLimits& limits : {GateLimits{}, kLimits}) {
    const GateDecision decision = decide(none, limits);
    CHECK(decision.verdict == Verdict::fail);
    CHECK_THAT(all(decision), ContainsSubstring("no cutter used so far can reach any of the "
                                                "surface"));
  }
  CHECK(decide(reach(0, 0, 100), {}).verdict == Verdict::fail);
  const GateDecision unknown = decide(reach(0, 60, 40), {});
  CHECK(unknown.verdict == Verdict::fail);
  CHECK_THAT(all(unknown), ContainsSubstring("none of the surface is proven or sampled to be in"));
  StageDeviation sampled = reach(0, 60, 40);
  sampled.reachable_area_mm2 = 1;
  const GateDecision by_samples = decide(sampled, {});
  CHECK(by_samples.verdict == Verdict::indeterminate);
  CHECK_THAT(all(by_samples), ContainsSubstring("none of the surface is proven to be in reach"));
  StageDeviation refuted = reach(0, 100, 0);
  refuted.reachable_area_mm2 = 1;
  CHECK(decide(refuted, {}).verdict == Verdict::fail);
  CHECK(decide(reach(1, 99, 0), {}).verdict == Verdict::pass);
}

TEST_CASE(
    "under cutters without proofs of reach the rest is judged, or samples say what is touched",
    "[unit]") {
  StageDeviation d = reach(0, 0, 100);
  d.uncut_mm = {0, 0.001}, d.gouge_mm = {0, 0.001}, d.coverage = 1;
  // A cutter that widens upwards: nothing is ever proven to be out of its reach.
  d.proven_reach.all_is_judged = true;
  CHECK(decide(d, kLimits).verdict == Verdict::pass);
  CHECK_THAT(all(decide(d, kLimits)), ContainsSubstring("undecided 100 mm²"));
  // Without a limit of uncut nothing is judged by it.
  CHECK(decide(d, {}).verdict == Verdict::indeterminate);
  d.uncut_mm = {0, 5};
  CHECK(decide(d, kLimits).verdict == Verdict::indeterminate);
  // A drill alone: touched places are found one by one.
  d = reach(0, 0, 100);
  d.coverage = 1;
  d.proven_reach.is_mapped = false;
  CHECK(decide(d, kLimits).verdict == Verdict::fail);
  d.reachable_area_mm2 = 1;
  CHECK(decide(d, kLimits).verdict == Verdict::pass);
}

TEST_CASE("missing raw stock is held against the gouge limit under its own name", "[unit]") {
  StageDeviation d = with({0, 0}, {0, 0});
  d.missing_stock = {finding({1, 2, 3}, 0.5, 0)};
  d.missing_stock_mm = {0.5, 0.51};
  const GateDecision beyond = decide(d, kLimits);
  CHECK(beyond.verdict == Verdict::fail);
  CHECK(all(beyond).find("missing stock: S lies between 0.5 mm and 0.51 mm outside the raw stock, "
                         "limit 10 µm: beyond the limit; deepest 0.5 mm at (1.000, 2.000, 3.000) "
                         "mm") != std::string::npos);
  d.missing_stock_mm = {0.009, 0.011};
  CHECK(decide(d, kLimits).verdict == Verdict::indeterminate);
  d.missing_stock_mm = {0.009, 0.01};
  CHECK(decide(d, kLimits).verdict == Verdict::pass);
  CHECK_THAT(all(decide(d, kLimits)), ContainsSubstring("within the limit"));
  d.missing_stock_mm = {0.5, 0.51};
  CHECK(decide(d, {}).verdict == Verdict::pass);
  CHECK_THAT(all(decide(d, {})), ContainsSubstring("missing stock: S lies between"));
  d.missing_stock_mm = {0, 1e-6};
  CHECK_THAT(all(decide(d, kLimits)), !ContainsSubstring("missing stock"));
}

TEST_CASE("what is out of reach is said beside every verdict", "[unit]") {
  StageDeviation d = reach(287.2, 12.3, 0.5);
  d.unavoidable_uncut_mm = {0.1, 0.25};
  CHECK(decide(d, {}).reasons ==
        std::vector<std::string>{
            "unreachable: 12.3 mm² (4.1 %), undecided 0.5 mm², unavoidable uncut up to 0.25 mm"});
  CHECK(decide(reach(300, 0, 0), {}).reasons.empty());
}

TEST_CASE("a process fault names its deepest place", "[unit]") {
  ProcessFault holder{"holder in the material", 2};
  holder.worst = ProcessFault::Place{{1, 2, 3}, 40, 0.25};
  const GateDecision decision = decide(with({0, 0}, {0, 0}), {}, std::span(&holder, 1));
  CHECK(decision.reasons ==
        std::vector<std::string>{"holder in the material: 2 moves; deepest 0.25 mm at (1.000, "
                                 "2.000, 3.000) mm, program line 40"});
  ProcessFault rapid{"rapid through standing material", 1};
  rapid.worst = ProcessFault::Place{{1, 2, 3}, 40, 0};
  rapid.is_open = true;
  CHECK(decide(std::span(&rapid, 1)).reasons.front() ==
        "rapid through standing material: 1 move; neither shown nor excluded, begins at (1.000, "
        "2.000, 3.000) mm, program line 40");
}

TEST_CASE("automatic resolution is a tenth of the tightest limit", "[unit]") {
  CHECK(automatic_resolution_mm(kLimits) == Approx(0.001));
  CHECK(automatic_resolution_mm({true, true, false, 0.05, 0.004, 0}) == Approx(0.0004));
  GateLimits unavoidable = kLimits;
  unavoidable.has_unavoidable = true, unavoidable.unavoidable_mm = 0.005;
  CHECK(automatic_resolution_mm(unavoidable) == Approx(0.0005));
  CHECK(automatic_resolution_mm({}) == Approx(0.001));
}

}  // namespace limitgauge::verifier
