#include <cmath>
#include <random>
#include <sstream>

#include "model/base/error.h"
#include "model/gcode/program_path.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

Program program_in(const std::string& text) {
  std::istringstream in(text);
  return read_program(in, "text.ngc");
}

std::string moves_text(const Program& program) {
  std::string text;
  for (const Motion& motion : program.motions) text += to_text(motion) + "\n";
  return text;
}

}  // namespace

TEST_CASE("a position is known once every axis was programmed in G90", "[unit][program]") {
  const Program program = program_in("G0 Z5\nX0\nG91 Y1\nG90 X1 Y2\n");
  REQUIRE(program.motions.size() == 4);
  CHECK_FALSE(program.motions[0].position_known);
  CHECK_FALSE(program.motions[2].position_known);
  CHECK(program.motions[3].position_known);
}

TEST_CASE("a feed rate in inches keeps its speed after a change to millimetres",
          "[unit][program]") {
  const Program program = program_in("G20 G0 X0 Y0 Z0\nF10\nG21 G1 X1\nF20 G20 X1\n");
  CHECK(program.motions[1].feed_mm_min == 254.0F);
  // F is carried out before G20 of the same block, in RS274/NGC's order.
  CHECK(program.motions[2].feed_mm_min == 20.0F);
}

TEST_CASE("arc radii may differ by LinuxCNC's tolerance", "[unit][program]") {
  const std::string start = "G0 X0 Y0 Z0 F10\n";
  // 0.02 mm apart: within 0.0283 mm.
  CHECK_NOTHROW(program_in(start + "G2 X2 I1.01\n"));
  // 0.2 mm apart at a radius of 300 mm: beyond 0.0283 mm, but within a thousandth.
  CHECK_NOTHROW(program_in(start + "G2 X600 I300.1\n"));
  CHECK_THROWS_AS(program_in(start + "G2 X600 I300.2\n"), InputError);
  // 4 mm apart at 10 m: within a thousandth, but beyond 2.83 mm.
  CHECK_THROWS_AS(program_in(start + "G2 X20000 I10002\n"), InputError);
}

TEST_CASE("a byte order mark, tabs and a missing last line end", "[unit][program]") {
  CHECK(moves_text(program_in("\xEF\xBB\xBFg0\tx1\ty2 z3")) == "1 rapid 1 2 3\n");
}

TEST_CASE("a radius a little too small for its chord makes a half circle", "[unit][program]") {
  const Program program = program_in("G0 X0 Y0 Z0 F10\nG2 X10 R4.9995\n");
  CHECK(program.motions[1].centre1 == 5);
  CHECK(program.motions[1].centre2 == 0);
}

TEST_CASE("arcs by radius pass through start and end on the asked side", "[property][program]") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> number(-50, 50);
  for (int round = 0; round < 500; ++round) {
    const double x = number(random), y = number(random);
    const double half_chord = std::hypot(x, y) / 2,
                 radius = half_chord * (1.01 + static_cast<double>(random() % 5));
    const bool clockwise = random() % 2 == 0, long_way = random() % 2 == 0;
    std::ostringstream text;
    text.precision(17);
    text << std::fixed << "G0 X0 Y0 Z0 F10\n"
         << (clockwise ? "G2" : "G3") << " X" << x << " Y" << y << " R"
         << (long_way ? -radius : radius) << "\n";
    const Motion arc = program_in(text.str()).motions.at(1);
    // Centres lie up to 250 mm away; a few roundings of that are 1e-13.
    CHECK(std::hypot(arc.centre1, arc.centre2) == Approx(radius).epsilon(1e-12));
    CHECK(std::hypot(arc.centre1 - x, arc.centre2 - y) == Approx(radius).epsilon(1e-12));
    // Left of the chord lies the centre of a short counter-clockwise arc.
    const double left = x * arc.centre2 - y * arc.centre1;
    CHECK((left > 0) == (clockwise == long_way));
  }
}

TEST_CASE("programs with any bytes changed give motions or an InputError", "[property][program]") {
  const std::string whole =
      "%\n(part) N10 G21 G90\nG0 X0 Y0 Z5 T1 M6\nS100 M3\nG1 Z-1.5 F100\nG2 X10 I5 P2 ; arc\n"
      "G18 G3 X20 R5\n/G4 P1\nM5\n%\n";
  std::mt19937 random(9);
  const std::string alphabet = "GMXYZIJKRFPSTNO0123456789.-+ ()%/;\n\r\t#[]\xFF";
  for (int round = 0; round < 5000; ++round) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change)
      text[random() % text.size()] = alphabet[random() % alphabet.size()];
    try {
      for (const Motion& motion : program_in(text).motions) CHECK(is_finite(motion.to));
    } catch (const InputError& error) {
      CHECK(error.place().line > 0);
      CHECK(error.place().column > 0);
    }
  }
}

TEST_CASE("the text of motions has the shortest decimals", "[unit][program]") {
  Motion motion;
  motion.line = 7;
  motion.to = {0.1, -0.0, 1e-7};
  CHECK(to_text(motion) == "7 rapid 0.1 0 1e-07");
  motion.kind = MotionKind::arc;
  motion.plane = ArcPlane::yz;
  motion.centre1 = 2.5;
  motion.turns = -3;
  CHECK(to_text(motion) == "7 arc 19 0.1 0 1e-07 2.5 0 -3");
}

namespace {

/// One letter a motion: s where the spindle is known to stand.
std::string spindle_text(const std::string& text) {
  std::string states;
  for (const Motion& motion : program_in(text).motions)
    states += motion.spindle_stopped ? 's' : '.';
  return states;
}

}  // namespace

TEST_CASE("a program that starts the spindle is held to it", "[unit][program]") {
  CHECK(spindle_text("G0 X0 Y0 Z0\nM3 S100\nX1\nM5\nX2\n") == "s.s");
  // Without M3 and M4 the operator has started it, until the program stops it.
  CHECK(spindle_text("G0 X0 Y0 Z0\nX1\n") == "..");
  CHECK(spindle_text("G0 X0 Y0 Z0\nM5\nX1\n") == ".s");
  // Stopped first and started later: nothing turned before.
  CHECK(spindle_text("G0 X0 Y0 Z0\nM5\nX1\nM4\nX2\n") == "ss.");
  // A tool change stops it, and comes before M3 in the same block.
  CHECK(spindle_text("M3\nG0 X0 Y0 Z0\nT1 M6\nX1\nM3\nX2\n") == ".s.");
  CHECK(spindle_text("M3\nG0 X0 Y0 Z0\nT1 M6 M3\nX1\n") == "..");
  CHECK(spindle_text("M3 S0\nG0 X0 Y0 Z0\nS5\nX1\n") == "s.");
}

TEST_CASE("moves carry the state of the spindle, chords of arcs too", "[unit][program]") {
  const Program program = program_in("G0 X10 Y0 Z0 F60\nM3\nG3 I-10\nM5\nG1 X0\n");
  const Toolpath path = to_toolpath(program, 0.1);
  REQUIRE(path.moves.size() > 4);
  CHECK_FALSE(path.moves.front().spindle_stopped);
  CHECK_FALSE(path.moves[path.moves.size() - 2].spindle_stopped);
  CHECK(path.moves.back().spindle_stopped);
}
