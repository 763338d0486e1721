#include "model/gcode/cycles/canned_cycle.h"

#include <sstream>

#include "model/base/error.h"
#include "tests/model/fixture_files.h"
#include "tests/model/gcode/canned_cycle_run.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

namespace {

CycleRun run_from(const Vec3& position_mm, bool return_to_r = true) {
  CycleRun run;
  run.context.position_mm = position_mm;
  run.context.return_to_r = return_to_r;
  return run;
}

std::string cycle_error_of(CycleRun run, int code, const std::string& words) {
  return message_of<InputError>([&] { run.block(code, words); });
}

const std::string kWholeWords = "X1 Y2 Z-3 R1 P1 Q1 I1 J1 K1";

}  // namespace

TEST_CASE("G81 as in the examples of LinuxCNC's documentation", "[unit][program][cycle]") {
  SECTION("absolute, from above R") {
    CHECK(run_from({1, 2, 3}, false).text(81, "X4 Y5 Z1.5 R2.8") ==
          "rapid 4 5 3\nrapid 4 5 2.8\nfeed 4 5 1.5\nrapid 4 5 3\n");
  }
  SECTION("incremental, three times, from below R") {
    CycleRun run = run_from({1, 2, 3}, false);
    run.context.incremental = true;
    CHECK(run.text(81, "X4 Y5 Z-0.5 R1.75 L3") ==
          "rapid 1 2 4.75\n"
          "rapid 5 7 4.75\nfeed 5 7 4.25\nrapid 5 7 4.75\n"
          "rapid 9 12 4.75\nfeed 9 12 4.25\nrapid 9 12 4.75\n"
          "rapid 13 17 4.75\nfeed 13 17 4.25\nrapid 13 17 4.75\n");
  }
  SECTION("absolute, from below R") {
    CHECK(run_from({0, 0, 0}, false).text(81, "X4 Y5 Z1.5 R2.8") ==
          "rapid 0 0 2.8\nrapid 4 5 2.8\nfeed 4 5 1.5\nrapid 4 5 2.8\n");
  }
}

TEST_CASE("polar words say where holes are", "[unit][program][cycle]") {
  // Multiples of 3-4-5: places along a ray through the origin are exact but for the last bit.
  CycleRun run = run_from({3, 4, 0});
  run.context.incremental = true;
  const CycleMotions row = run.block(81, "@5 Z-2 R1 L3");
  REQUIRE(row.moves.size() == 10);
  for (int hole = 0; hole < 3; ++hole) {
    const Vec3 bottom_mm{6.0 + 3 * hole, 8.0 + 4 * hole, -1};
    CHECK(distance(row.moves[2 + 3 * hole].to_mm, bottom_mm) < 1e-12);
    CHECK_FALSE(row.moves[2 + 3 * hole].stated[0]);
  }
  run.context.incremental = false;
  const CycleMotions one = run.block(81, "@10 ^90 Z-2 R1");
  CHECK(distance(one.moves.back().to_mm, {0, 10, 1}) < 1e-12);
  CHECK(one.moves.back().stated == std::array{true, true, true});
  // The distance of where the tool stands.
  const CycleMotions turned = run.block(81, "^180");
  CHECK(distance(turned.moves.back().to_mm, {-10, 0, 1}) < 1e-12);
  CHECK_FALSE(turned.moves.back().stated[1]);
}

TEST_CASE("G98 returns to where the run began, G99 to R", "[unit][program][cycle]") {
  CycleRun run = run_from({0, 0, 10}, false);
  run.block(81, "X1 Z-1 R2");
  CHECK(run.text(81, "X2") == "rapid 2 0 10\nrapid 2 0 2\nfeed 2 0 -1\nrapid 2 0 10\n");
  run.context.return_to_r = true;
  CHECK(run.text(81, "X3") == "rapid 3 0 10\nrapid 3 0 2\nfeed 3 0 -1\nrapid 3 0 2\n");
  CHECK(run.text(81, "X4") == "rapid 4 0 2\nfeed 4 0 -1\nrapid 4 0 2\n");
  // The initial level outlives G99; LinuxCNC goes there and across at once.
  run.context.return_to_r = false;
  CHECK(run.text(81, "X5") == "rapid 5 0 10\nrapid 5 0 2\nfeed 5 0 -1\nrapid 5 0 10\n");
  run.go_to({0, 0, 4});
  CHECK(run.text(81, "X1 Z-1 R2") == "rapid 1 0 4\nrapid 1 0 2\nfeed 1 0 -1\nrapid 1 0 4\n");
}

TEST_CASE("another cycle of a run keeps the initial level and no words", "[unit][program][cycle]") {
  CycleRun run = run_from({0, 0, 10}, false);
  run.context.return_to_r = true;
  run.block(81, "X1 Z-1 R2");
  CHECK_THAT(cycle_error_of(run, 85, "X2 Z-1"),
             ContainsSubstring("the first G85 of a run has no R"));
  CHECK_THAT(cycle_error_of(run, 85, "X2 R2"),
             ContainsSubstring("the first G85 of a run has no Z"));
  run.context.return_to_r = false;
  CHECK(run.block(85, "X2 Z-1 R2").end_mm.z == 10);
}

TEST_CASE("a peck is counted from R, the last one is what remains", "[unit][program][cycle]") {
  CHECK(run_from({0, 0, 5}).text(83, "X1 Z-4 R1 Q2") ==
        "rapid 1 0 5\nrapid 1 0 1\n"
        "feed 1 0 -1\nrapid 1 0 1\nrapid 1 0 -0.746\n"
        "feed 1 0 -3\nrapid 1 0 1\nrapid 1 0 -2.746\n"
        "feed 1 0 -4\nrapid 1 0 1\n");
  CHECK(run_from({0, 0, 5}, false).text(73, "X1 Z-4 R1 Q2") ==
        "rapid 1 0 5\nrapid 1 0 1\n"
        "feed 1 0 -1\nrapid 1 0 -0.746\n"
        "feed 1 0 -3\nrapid 1 0 -2.746\n"
        "feed 1 0 -4\nrapid 1 0 5\n");
  CHECK(run_from({0, 0, 5}).text(83, "X1 Z-1 R1 Q2") ==
        "rapid 1 0 5\nrapid 1 0 1\nfeed 1 0 -1\nrapid 1 0 1\n");
}

TEST_CASE("pecks in inches clear by a hundredth of an inch", "[unit][program][cycle]") {
  CycleRun run = run_from({0, 0, 50.8});
  run.context.unit_mm = 25.4;
  const auto moves = run.block(73, "X1 Z0 R1 Q0.5").moves;
  REQUIRE(moves.size() == 6);
  CHECK(moves[2].to_mm == Vec3{25.4, 0, 12.7});
  CHECK(moves[3].to_mm == Vec3{25.4, 0, 12.7 + 0.254});
  CHECK(moves[4].to_mm == Vec3{25.4, 0, 0});
}

TEST_CASE("pecks in inches and G91 are counted from R", "[unit][program][cycle]") {
  CycleRun run = run_from({0, 0, 50.8});
  run.context.unit_mm = 25.4;
  run.context.incremental = true;
  const auto moves = run.block(73, "X1 Z-1 R-1 Q0.5").moves;
  REQUIRE(moves.size() == 6);
  CHECK(moves[1].to_mm == Vec3{25.4, 0, 25.4});
  CHECK(moves[2].to_mm == Vec3{25.4, 0, 12.7});
  CHECK(moves[4].to_mm == Vec3{25.4, 0, 0});
}

TEST_CASE("how each cycle leaves the hole", "[unit][program][cycle]") {
  const std::string in = "rapid 1 0 5\nrapid 1 0 2\nfeed 1 0 -1\n";
  const auto out = [&](int code) { return run_from({0, 0, 5}, false).text(code, "X1 Z-1 R2 P1"); };
  CHECK(out(82) == in + "rapid 1 0 5\n");
  CHECK(out(74) == in + "feed 1 0 5\n");
  CHECK(out(84) == in + "feed 1 0 5\n");
  CHECK(out(85) == in + "feed 1 0 2\nrapid 1 0 5\n");
  CHECK(out(86) == in + "rapid 1 0 5 stopped\n");
  CHECK(out(88) == in);
  CHECK(out(89) == in + "feed 1 0 5\n");
}

TEST_CASE("G88 leaves the way out to the operator and goes on above", "[unit][program][cycle]") {
  CycleRun run = run_from({0, 0, 5}, false);
  CHECK(run.block(88, "X1 Z-1 R2 P0").end_mm == Vec3{1, 0, 5});
  CHECK(run.text(88, "X2") == "rapid 2 0 5\nrapid 2 0 2\nfeed 2 0 -1\n");
}

TEST_CASE("G87 goes down beside the axis and bores upwards", "[unit][program][cycle]") {
  CHECK(run_from({1, 2, 3}).text(87, "X5 Y6 Z-4 R1 I1 J2 K-2") ==
        "rapid 5 6 3\nrapid 5 6 1\nrapid 6 8 1\n"
        "rapid 6 8 -4 stopped\nrapid 5 6 -4 stopped\n"
        "feed 5 6 -2\nfeed 5 6 -4\n"
        "rapid 6 8 -4 stopped\nrapid 6 8 1 stopped\nrapid 5 6 1 stopped\n");
}

TEST_CASE("G87 in G91 counts its K from the bottom", "[unit][program][cycle]") {
  CycleRun run = run_from({1, 2, 3});
  run.context.incremental = true;
  CHECK(run.text(87, "X4 Y4 Z-5 R-2 I1 J2 K2") ==
        "rapid 5 6 3\nrapid 5 6 1\nrapid 6 8 1\n"
        "rapid 6 8 -4 stopped\nrapid 5 6 -4 stopped\n"
        "feed 5 6 -2\nfeed 5 6 -4\n"
        "rapid 6 8 -4 stopped\nrapid 6 8 1 stopped\nrapid 5 6 1 stopped\n");
}

TEST_CASE("the axes that a move places absolutely", "[unit][program][cycle]") {
  using Stated = std::array<bool, 3>;
  CycleRun run = run_from({0, 0, 0}, false);
  const auto lifted = run.block(81, "X1 Z-1 R2").moves;
  REQUIRE(lifted.size() == 4);
  CHECK(lifted[0].stated == Stated{false, false, true});
  CHECK(lifted[1].stated == Stated{true, false, true});
  CHECK(lifted[3].stated == Stated{true, false, true});
  // The level that the run began at is as unknown at the end of the hole as it was before.
  run.go_to({0, 0, 9});
  const auto found = run.block(81, "Y1 Z-1 R2").moves;
  REQUIRE(found.size() == 4);
  CHECK(found[0].stated == Stated{false, true, false});
  CHECK(found[1].stated == Stated{false, true, true});
  CHECK(found[2].stated == Stated{false, true, true});
  CHECK(found[3].stated == Stated{false, true, false});
  run.context.incremental = true;
  for (const CycleMove& move : run.block(81, "X1 Y1 Z-1 R2").moves)
    CHECK(move.stated == Stated{false, false, false});
}

TEST_CASE("words that a cycle needs and has not", "[unit][program][cycle]") {
  CycleRun run;
  CHECK(cycle_error_of(run, 81, "X1 Z-1") ==
        "cycle.ngc:1:1: error: the first G81 of a run has no R; expected R, the level where the "
        "rapid ends");
  CHECK_THAT(cycle_error_of(run, 81, "X1 R1"),
             ContainsSubstring("the first G81 of a run has no Z"));
  run.context.plane = ArcPlane::yz;
  CHECK_THAT(cycle_error_of(run, 81, "Z1 R1"),
             ContainsSubstring("the first G81 of a run has no X"));
  run.context.plane = ArcPlane::xy;
  for (const int code : {73, 83})
    CHECK_THAT(cycle_error_of(run, code, "X1 Z-1 R1"), ContainsSubstring("of a run has no Q"));
  for (const int code : {82, 86, 88, 89})
    CHECK_THAT(cycle_error_of(run, code, "X1 Z-1 R1"), ContainsSubstring("of a run has no P"));
  CHECK_THAT(cycle_error_of(run, 87, "X1 Z-1 R1 J1 K1"), ContainsSubstring("of a run has no I"));
  CHECK_THAT(cycle_error_of(run, 87, "X1 Z-1 R1 I1 K1"), ContainsSubstring("of a run has no J"));
  CHECK_THAT(cycle_error_of(run, 87, "X1 Z-1 R1 I1 J1"), ContainsSubstring("of a run has no K"));
  for (const int code : {74, 81, 84, 85})
    CHECK(cycle_error_of(run, code, "X1 Z-1 R1") == "no error");
}

TEST_CASE("words of a cycle that say nothing", "[unit][program][cycle]") {
  const CycleRun run;
  CHECK(cycle_error_of(run, 81, "X1 Z2 R1") ==
        "cycle.ngc:1:7: error: R lies below the bottom of the hole, Z; expected R at or above it");
  CHECK(cycle_error_of(run, 81, "X1 Z1 R1") == "no error");
  CHECK_THAT(cycle_error_of(run, 83, "X1 Z-2 R1 Q0"), ContainsSubstring(":1:11: error: a peck"));
  CHECK_THAT(cycle_error_of(run, 73, "X1 Z-2 R1 Q-1"),
             ContainsSubstring("a peck that is not above 0"));
  CHECK_THAT(cycle_error_of(run, 82, "X1 Z-2 R1 P-1"), ContainsSubstring("a negative dwell"));
  for (const std::string l : {"L0", "L-1", "L1.5", "L1.0005"})
    CHECK_THAT(cycle_error_of(run, 81, "X1 Z-2 R1 " + l),
               ContainsSubstring("repeats of a canned cycle"));
  CHECK(cycle_error_of(run, 81, "X1 Z-2 R1 L1.00005") == "no error");
}

TEST_CASE("what the machine is doing may forbid a cycle", "[unit][program][cycle]") {
  CycleRun run;
  run.context.inverse_time = true;
  CHECK_THAT(cycle_error_of(run, 81, kWholeWords), ContainsSubstring("inverse time"));
  run.context.inverse_time = false;
  run.context.compensated = true;
  CHECK_THAT(cycle_error_of(run, 81, kWholeWords), ContainsSubstring("compensation"));
  run.context.compensated = false;
  run.context.spindle = SpindleState::stopped;
  for (const int code : {74, 84, 86, 87, 88})
    CHECK_THAT(cycle_error_of(run, code, kWholeWords), ContainsSubstring("spindle stands still"));
  for (const int code : {73, 81, 82, 83, 85, 89})
    CHECK(cycle_error_of(run, code, kWholeWords) == "no error");
  run.context.spindle = SpindleState::clockwise;
  CHECK_THAT(cycle_error_of(run, 74, kWholeWords), ContainsSubstring("turns clockwise"));
  CHECK(cycle_error_of(run, 84, kWholeWords) == "no error");
  run.context.spindle = SpindleState::counter_clockwise;
  CHECK_THAT(cycle_error_of(run, 84, kWholeWords), ContainsSubstring("turns counter-clockwise"));
  CHECK(cycle_error_of(run, 74, kWholeWords) == "no error");
  run.context.plane = ArcPlane::zx;
  CHECK_THAT(cycle_error_of(run, 74, "Y-3 R1"), ContainsSubstring("G74 outside G17"));
}

TEST_CASE("units may not change within a run of cycles", "[unit][program][cycle]") {
  CycleRun run;
  run.block(81, "X1 Z-1 R1");
  run.context.unit_mm = 25.4;
  CHECK_THAT(cycle_error_of(run, 81, "X2"), ContainsSubstring("a change of units"));
  run.go_to({0, 0, 0});
  CHECK(cycle_error_of(run, 81, "X2 Z-1 R1") == "no error");
}

TEST_CASE("a block of a cycle is bounded in moves and in place", "[unit][program][cycle]") {
  const CycleRun run;
  CHECK_THAT(cycle_error_of(run, 81, "X1 Z-1 R1 L10001"),
             ContainsSubstring("more than 100000 moves"));
  CHECK_THAT(cycle_error_of(run, 81, "X1 Z-1 R1 L1000000000000"),
             ContainsSubstring("repeats of a canned cycle; expected at most 100000"));
  CHECK(cycle_error_of(run, 83, "X1 Z-1 R1 Q0.00001") ==
        "cycle.ngc:1:11: error: a canned cycle of more than 100000 moves; expected a larger Q");
  CHECK_THAT(cycle_error_of(run, 83, "X1 Z-1 R1 Q0.01 L1000"),
             ContainsSubstring(":1:17: error: a canned cycle of more than 100000 moves"));
  // Pecks that are lost in rounding never get to the bottom.
  CHECK_THAT(cycle_error_of(run, 83, "X1 Z0 R100000000 Q0.000000001"),
             ContainsSubstring("more than 100000 moves"));
  CHECK_THAT(cycle_error_of(run, 81, "X1 Z-1 R2000000000"), ContainsSubstring("a level beyond"));
  CHECK_THAT(cycle_error_of(run, 81, "X1 Z-2000000000 R1"), ContainsSubstring("a level beyond"));
  CHECK_THAT(cycle_error_of(run, 81, "X2000000000 Z-1 R1"),
             ContainsSubstring("beyond any machine"));
  CycleRun steps;
  steps.context.incremental = true;
  CHECK_THAT(cycle_error_of(steps, 81, "X600000000 Z-1 R1 L2"),
             ContainsSubstring("beyond any machine"));
  CHECK(cycle_error_of(steps, 81, "X600000000 Z-1 R1") == "no error");
}

TEST_CASE("which words the cycles take", "[unit][program][cycle]") {
  CHECK(is_canned_cycle(730));
  CHECK(is_canned_cycle(740));
  CHECK_FALSE(is_canned_cycle(760));
  CHECK_FALSE(is_canned_cycle(800));
  for (int code = 810; code <= 890; code += 10) CHECK(is_canned_cycle(code));
  CHECK_FALSE(is_canned_cycle(815));
  for (const char letter : {'R', 'L'}) CHECK(cycle_takes(850, letter));
  CHECK(cycle_takes(830, 'Q'));
  CHECK_FALSE(cycle_takes(830, 'P'));
  CHECK(cycle_takes(840, 'P'));
  CHECK(cycle_takes(870, 'K'));
  CHECK_FALSE(cycle_takes(810, 'K'));
  CHECK_FALSE(cycle_takes(10, 'R'));
}
