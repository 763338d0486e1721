#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>

#include "model/base/error.h"
#include "model/gcode/program_path.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

Toolpath path_of(const std::string& text, double chord_error_mm) {
  std::istringstream in(text);
  return to_toolpath(read_program(in, "text.ngc"), chord_error_mm);
}

}  // namespace

TEST_CASE("a path without a stated start begins where every axis is known", "[unit][program]") {
  const Toolpath path = path_of("G0 Z5\nX1 Y2\nG1 X3 F100\nG0 Z9\n", 0.01);
  CHECK(path.start == Vec3{1, 2, 5});
  REQUIRE(path.moves.size() == 2);
  CHECK(path.moves[0].to == Vec3{3, 2, 5});
  CHECK(path.moves[0].kind == MoveKind::feed);
  CHECK(path.moves[0].feed_mm_min == 100.0F);
  CHECK(path.moves[0].line == 3);
  CHECK(path.moves[1].kind == MoveKind::rapid);
  CHECK(path.moves[1].feed_mm_min == 0.0F);
  CHECK(path.chord_error_mm == 0);
}

TEST_CASE("a chord error that is no length is refused", "[unit][program]") {
  CHECK_THROWS_AS(to_toolpath(Program{}, 0), std::invalid_argument);
  CHECK_THROWS_AS(to_toolpath(Program{}, std::nan("")), std::invalid_argument);
}

TEST_CASE("more chords than memory holds are refused before they are made", "[unit][program]") {
  CHECK_THROWS_AS(path_of("G0 X0 Y0 Z0 F1\nG2 I1000000 P9999\n", 1e-12), ResourceError);
}

TEST_CASE("a quarter circle ends where it should and bulges the right way", "[unit][program]") {
  const Toolpath path = path_of("G0 X10 Y0 Z0 F60\nG3 X0 Y10 I-10\n", 0.01);
  CHECK(path.moves.back().to == Vec3{0, 10, 0});
  for (const Move& move : path.moves) {
    CHECK(move.to.x >= 0);
    CHECK(move.to.y >= 0);
    CHECK(move.line == 2);
    CHECK(move.feed_mm_min == 60.0F);
  }
}

TEST_CASE("chord points lie on the arc, and chords within the tolerance", "[property][program]") {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), size(0.5, 80);
  for (int round = 0; round < 300; ++round) {
    const double radius = size(random), from = angle(random), to = angle(random);
    const int turns = 1 + static_cast<int>(random() % 3);
    const bool clockwise = random() % 2 == 0;
    const double limit_mm = std::pow(10, -1 - static_cast<int>(random() % 4));
    Program program;
    Motion start;
    start.to = {radius * std::cos(from), radius * std::sin(from), 3};
    Motion arc;
    arc.kind = MotionKind::arc;
    arc.to = {radius * std::cos(to), radius * std::sin(to), -2};
    arc.turns = clockwise ? -turns : turns;
    program.motions = {start, arc};
    const Toolpath path = to_toolpath(program, limit_mm);
    double swept = 0;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Vec3 a = move_from(path, i), b = path.moves[i].to;
      // The points are computed from angles up to 20 radians: 1e-15 of 80 mm, times 20.
      CHECK(std::hypot(b.x, b.y) == Approx(radius).margin(2e-12));
      const Vec3 middle = lerp(a, b, 0.5);
      const double sagitta_mm = radius - std::hypot(middle.x, middle.y);
      CHECK(sagitta_mm <= path.chord_error_mm + 2e-12);
      swept += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    }
    CHECK(path.chord_error_mm <= limit_mm);
    double expected = clockwise ? from - to : to - from;
    if (expected <= 0) expected += 2 * std::numbers::pi;
    expected += 2 * std::numbers::pi * (turns - 1);
    CHECK(std::abs(swept) == Approx(expected).margin(1e-9));
    CHECK((swept < 0) == clockwise);
    CHECK(path.moves.back().to == arc.to);
  }
}

TEST_CASE("the number of chords is the least that the tolerance allows", "[unit][program]") {
  // r - sqrt(r² - c²/4) with r = 10 and 0.01: half angle acos(0.999), 70.24 chords a turn.
  const Toolpath path = path_of("G0 X10 Y0 Z0 F60\nG3 I-10\n", 0.01);
  CHECK(path.moves.size() == 71);
  CHECK(path.chord_error_mm == Approx(10 * (1 - std::cos(std::numbers::pi / 71))).epsilon(1e-9));
}

TEST_CASE("a helix descends evenly", "[unit][program]") {
  const Toolpath path = path_of("G0 X10 Y0 Z8 F60\nG3 I-10 Z0 P2\n", 0.1);
  const auto count = static_cast<double>(path.moves.size());
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    CHECK(path.moves[i].to.z == Approx(8 - 8 * static_cast<double>(i + 1) / count).margin(1e-12));
}

TEST_CASE("arcs in the other planes turn as seen from their third axis", "[unit][program]") {
  // G18: Z is the first axis and X the second, so a counter-clockwise quarter leads from +Z to +X.
  const Toolpath zx = path_of("G0 X0 Y0 Z10 F60\nG18 G3 X10 Z0 K-10\n", 0.1);
  for (const Move& move : zx.moves) CHECK((move.to.x >= 0 && move.to.z >= 0));
  const Toolpath yz = path_of("G0 X0 Y10 Z0 F60\nG19 G3 Y0 Z10 J-10\n", 0.1);
  for (const Move& move : yz.moves) CHECK((move.to.y >= 0 && move.to.z >= 0));
}

TEST_CASE("an arc whose radii differ becomes a spiral within the tolerance", "[unit][program]") {
  // From radius 10 to radius 10.02, half a turn.
  const Toolpath path = path_of("G0 X-10 Y0 Z0 F60\nG2 X10.02 I10\n", 0.001);
  CHECK(path.moves.back().to == Vec3{10.02, 0, 0});
  CHECK(path.chord_error_mm <= 0.001);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 middle = lerp(move_from(path, i), path.moves[i].to, 0.5);
    const double angle = std::numbers::pi - std::atan2(middle.y, middle.x);
    const double spiral_mm = 10 + 0.02 * angle / std::numbers::pi;
    // The spiral's radius at that angle; the spiral's slope moves the foot by less than 1e-6.
    CHECK(std::abs(std::hypot(middle.x, middle.y) - spiral_mm) <= path.chord_error_mm + 1e-6);
  }
}

TEST_CASE("a program laid into the part's frame", "[unit][program]") {
  std::istringstream in("G0 X0 Y0 Z5\nG1 X10 F100\nG3 X10 Y4 J2\n");
  const Program program = read_program(in, "text.ngc");
  // The work frame's zero lies at (100, 50, 7) on the machine and at (1, 2, 3) in the part, turned
  // by a quarter: X runs along the part's Y.
  PathOptions options;
  options.machine_in_part = machine_in_part({90, {1, 2, 3}}, {{0, 0, 0}, 0});
  const Toolpath path = to_toolpath(program, options);
  CHECK(path.start == Vec3{1, 2, 8});
  CHECK(path.moves.front().to == Vec3{1, 12, 8});
  CHECK(path.moves.back().to == Vec3{-3, 12, 8});
  // Every chord's end lies on the turned circle.
  for (std::size_t i = 1; i < path.moves.size(); ++i)
    CHECK(distance(path.moves[i].to, {-1, 12, 8}) == Approx(2).epsilon(1e-12));
  CHECK(machine_in_part({90, {1, 2, 3}}, {{100, 50, 7}, 0})({100, 50, 7}) == Vec3{1, 2, 3});
  CHECK(machine_in_part({0, {}}, {{100, 50, 7}, 90})({90, 50, 7}) == Vec3{0, 10, 0});
  CHECK(highest_z_mm(program, options.machine_in_part) == 8);
}

TEST_CASE("an arc of more chords than there is room for names its line", "[unit][program]") {
  std::istringstream in("G0 X0 Y0 Z5\nG2 X0 Y0 I1000000 P10000 F100\n");
  const Program program = read_program(in, "text.ngc");
  PathOptions options;
  options.most_moves = 1e6;
  options.chord_error_mm = 0.001;
  CHECK(test::message_of<ResourceError>([&] { to_toolpath(program, options); }) ==
        "line 2 of the program: more than 1 million moves at a chord error of 0.001 mm; a wider "
        "verification.resolution needs fewer");
}

TEST_CASE("part of a program starts where the part before it ended", "[unit][program]") {
  std::istringstream in("G0 X0 Y0 Z5\nG1 X10 F100\nX20\nX30\n");
  const Program program = read_program(in, "text.ngc");
  PathOptions options;
  options.first = 2, options.last = 3;
  const Toolpath path = to_toolpath(program, options);
  CHECK(path.start == Vec3{10, 0, 5});
  REQUIRE(path.moves.size() == 1);
  CHECK(path.moves[0].to == Vec3{20, 0, 5});
}

TEST_CASE("a tool that parks goes up, across and down again", "[unit][program]") {
  const auto at = [](double x, double y, double z, bool parked) {
    Motion motion;
    motion.to = {x, y, z};
    motion.parked = parked;
    return motion;
  };
  Program program;
  program.motions = {at(1, 2, 5, false), at(1, 2, 5, true), at(8, 9, 5, true), at(8, 9, 3, false)};
  PathOptions options;
  options.park_z_mm = 50;
  const Toolpath path = to_toolpath(program, options);
  CHECK(path.start == Vec3{1, 2, 5});
  REQUIRE(path.moves.size() == 3);
  CHECK(path.moves[0].to == Vec3{1, 2, 50});
  CHECK(path.moves[1].to == Vec3{8, 9, 50});
  CHECK(path.moves[2].to == Vec3{8, 9, 3});
  CHECK(path.moves[0].kind == MoveKind::rapid);
  options.first = 2;
  CHECK(to_toolpath(program, options).start == Vec3{1, 2, 50});
}
