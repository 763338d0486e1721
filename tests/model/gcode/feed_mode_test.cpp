#include <cmath>
#include <numbers>

#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

float last_feed(const std::string& text) {
  return read_text("G21 G0 X0 Y0 Z0\n" + text).motions.back().feed_mm_min;
}

}  // namespace

TEST_CASE("inverse time turns into a feed rate by each motion's length", "[unit][gcode]") {
  CHECK(last_feed("G93 G1 X3 Y4 F2\n") == 10.0F);
  CHECK(last_feed("G93\nG1 X3 Y4 F2\nX0 Y0 F4\n") == 20.0F);
  // Half a circle of radius 5 and, by P, one and a half; a helix of 3, 4: hypot.
  const auto pi = static_cast<float>(std::numbers::pi);
  CHECK(last_feed("G93 G2 X10 I5 F2\n") == Approx(10 * pi));
  CHECK(last_feed("G93 G2 X10 I5 P2 F2\n") == Approx(30 * pi));
  CHECK(last_feed("G93 G3 X0 I5 F1\n") == Approx(10 * pi));
  CHECK(last_feed("G93 G2 X10 Z5 I5 F1\n") == Approx(5 * std::hypot(pi, 1.0F)));
  CHECK(last_feed("G20 G93 G1 X1 F2\n") == 50.8F);
  CHECK(error_of("G93 G1 X1 F2\nX2\n") ==
        "2:1: error: a feed motion in inverse time (G93) without its F; expected F above 0 in each "
        "block: one by the minutes of the motion");
}

TEST_CASE("F that inverse time has no use for is listed", "[unit][gcode]") {
  const Program program = read_text("G21 G93 F3\nG0 X0 F4\nG1 X1 F5\n");
  REQUIRE(program.ignored.size() == 2);
  CHECK(program.ignored[0].word == "F3");
  CHECK(program.ignored[1].word == "F4");
  CHECK(program.ignored[1].line == 2);
}

TEST_CASE("a feed per revolution goes by the spindle's speed", "[unit][gcode]") {
  CHECK(last_feed("G95 S1000 F0.1\nG1 X1\n") == 100.0F);
  CHECK(last_feed("G95 S1000 F0.1\nS2000 G1 X1\n") == 200.0F);
  CHECK(last_feed("G20\nG95 S1000 F0.1\nG1 X1\n") == 2540.0F);
  CHECK(error_of("G95 F1\nG1 X1\n").find("2:1: error: a feed per revolution without a spindle") ==
        0);
  CHECK(
      error_of("G95 F1 G96 S100\nG1 X1\n").find("2:1: error: a feed per revolution at constant") ==
      0);
  CHECK(last_feed("G95 F0.1 G96 D500 S100\nG97 S10\nG1 X1\n") == 1.0F);
}

TEST_CASE("a change of the feed mode forgets the feed rate", "[unit][gcode]") {
  CHECK(last_feed("F100 G1 X1\nG94\nX2\n") == 0.0F);
  CHECK(last_feed("G93 G1 X1 F5\nG94\nX2\n") == 0.0F);
  CHECK(last_feed("G94 F7 G1 X2\n") == 7.0F);
}

TEST_CASE("Siemens's G70 leaves feeds in millimetres, G700 does not", "[unit][gcode]") {
  MachineSetup machine;
  machine.control = Control::siemens;
  machine.assume_fresh_machine = true;
  const auto feed = [&](const std::string& code) {
    const Program program = read_text(code + " G90\nG0 X0 Y0 Z0\nG1 X1 F100\n", machine);
    CHECK(program.motions.back().to.x == Approx(25.4));
    CHECK(assumes(program, "feeds are taken to be in millimetres") == (code == "G70"));
    return program.motions.back().feed_mm_min;
  };
  CHECK(feed("G70") == Approx(100));
  CHECK(feed("G700") == Approx(2540));
  CHECK(read_text("G700 G90\nG0 X0 Y0 Z0\nG1 X1 F100\nG71\nG1 X2 F100\n", machine)
            .motions.back()
            .feed_mm_min == Approx(100));
}
