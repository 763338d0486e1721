#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>

#include "model/base/error.h"
#include "model/gcode/program_path.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

void check_same_motions(const Toolpath& a, const Toolpath& b) {
  CHECK(a.start == b.start);
  REQUIRE(a.moves.size() == b.moves.size());
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    CAPTURE(i);
    CHECK(a.moves[i].to == b.moves[i].to);
    CHECK(a.moves[i].kind == b.moves[i].kind);
    CHECK(a.moves[i].feed_mm_min == b.moves[i].feed_mm_min);
    CHECK(a.moves[i].line == b.moves[i].line);
  }
}

Toolpath read_back(const std::string& text) {
  std::istringstream in(text);
  return to_toolpath(read_program(in, "written.ngc"), 0.001);
}

}  // namespace

TEST_CASE("a written program, letter by letter", "[unit][program]") {
  Toolpath path;
  path.start = {0, 0, 10};
  path.moves = {{{1.00004, 2, 10}, 0, 0, MoveKind::rapid},
                {{1, 2, -0.5}, 300, 0, MoveKind::feed},
                {{1.00001, 2.5, -0.5}, 300, 0, MoveKind::feed},
                {{1, 2.5, -0.50001}, 450.5F, 0, MoveKind::feed},
                {{1, 2.5, 10}, 77, 0, MoveKind::rapid}};
  std::ostringstream out;
  write_program(path, {"part", "first (and\nsecond) line", 4, 12000, 3}, out);
  CHECK(out.str() ==
        "(part)\n(first [and)\n(second] line)\nG21 G90 G94 G17 G40 G49\nT3 M6\nM3 S12000\n"
        "G0 Z10\nX0 Y0\nX1 Y2\nG1 Z-0.5 F300\nY2.5\nX1 F450.5\nG0 Z10\nM5\nM30\n");
  CHECK(path.moves[0].to == Vec3{1, 2, 10});
  CHECK(path.moves[0].line == 9);
  CHECK(path.moves[4].line == 13);
  CHECK(path.moves[4].feed_mm_min == 0.0F);
  check_same_motions(path, read_back(out.str()));
}

TEST_CASE("a path of no moves is written as its start", "[unit][program]") {
  Toolpath path;
  path.start = {-0.00001, 2, 3};
  std::ostringstream out;
  write_program(path, {}, out);
  CHECK_THAT(out.str(), ContainsSubstring("G0 Z3\nX0 Y2\nM5\nM30\n"));
  check_same_motions(path, read_back(out.str()));
}

TEST_CASE("paths that cannot be written are refused before anything is", "[unit][program]") {
  const auto refused = [](const Move& move, const WriterOptions& options) {
    Toolpath path;
    path.moves = {move};
    std::ostringstream out;
    CHECK_THROWS_AS(write_program(path, options, out), std::invalid_argument);
    CHECK(out.str().empty());
  };
  const Move good{{1, 2, 3}, 100, 0, MoveKind::feed};
  refused({{std::nan(""), 0, 0}, 100, 0, MoveKind::feed}, {});
  refused({{1e12, 0, 0}, 100, 0, MoveKind::feed}, {});
  refused({{1, 2, 3}, 0, 0, MoveKind::feed}, {});
  refused({{1, 2, 3}, std::numeric_limits<float>::infinity(), 0, MoveKind::feed}, {});
  refused(good, {"", "", 10, 0, 1});
  refused(good, {"", "", -1, 0, 1});
  refused(good, {"", "", 4, -5, 1});
  refused(good, {"", "", 4, 0, -1});
  refused(good, {.tool_number = 10000});
  refused(good, {.arc_tolerance_mm = 0.0});
  refused(good, {.arc_tolerance_mm = std::nan("")});
  for (const Dialect dialect : {Dialect::fanuc, Dialect::grbl}) {
    refused(good, {.decimals = 5, .dialect = dialect});
    // Eight digits: four before the point and four behind it.
    refused({{10000, 0, 0}, 100, 0, MoveKind::feed}, {.dialect = dialect});
    refused({{1, 2, 3}, 100000, 0, MoveKind::feed}, {.dialect = dialect});
    refused({{1, 2, 3}, 0.0004F, 0, MoveKind::feed}, {.dialect = dialect});
  }
}

TEST_CASE("a disk that takes no more is a ResourceError", "[unit][program]") {
  Toolpath path;
  path.moves = {{{1, 2, 3}, 100, 0, MoveKind::feed}};
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  CHECK_THROWS_AS(write_program(path, {}, out), ResourceError);
}

TEST_CASE("random paths are the same after writing and reading", "[property][program]") {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> number(-200, 200);
  for (int round = 0; round < 120; ++round) {
    Toolpath path;
    path.start = {number(random), number(random), number(random)};
    Vec3 at = path.start;
    float feed = 100;
    for (int i = 0; i < 200; ++i) {
      // Some moves change one axis, some less than a digit, some nothing.
      const int axis = static_cast<int>(random() % 3);
      if (random() % 3 == 0) at[axis] = number(random);
      if (random() % 3 == 0) at = {number(random), number(random), number(random)};
      if (random() % 5 == 0) at[axis] += 1e-7;
      if (random() % 4 == 0) feed = static_cast<float>(std::pow(10, 1 + number(random) / 100));
      const bool rapid = random() % 4 == 0;
      path.moves.push_back({at, feed, 0, rapid ? MoveKind::rapid : MoveKind::feed});
    }
    const Toolpath before = path;
    const int decimals = static_cast<int>(random() % 10);
    std::ostringstream out;
    write_program(path, {"random", "", decimals, 0, 1}, out);
    check_same_motions(path, read_back(out.str()));
    // Rounding moves no coordinate by more than half a unit in the last decimal, and the binary
    // rounding of 200 mm (3e-14).
    const double half_mm = 0.5 * std::pow(10, -decimals) + 3e-14;
    REQUIRE(path.moves.size() == before.moves.size());
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Vec3 moved = path.moves[i].to - before.moves[i].to;
      CHECK(std::max({std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)}) <= half_mm);
    }
    std::ostringstream again;
    write_program(path, {"random", "", decimals, 0, 1}, again);
    CHECK(again.str() == out.str());
  }
}
