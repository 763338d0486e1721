#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/model/fixture_files.h"
#include "tests/model/gcode/compensated_contour.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

TEST_CASE("a square cut outside has a quarter round at each corner", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 3, {-20, 0, 0});
  contour.line(0, 0);
  contour.line(0, 20);
  contour.line(20, 20);
  CHECK(contour.compensation().waiting() == 1);
  contour.compensation().end();
  contour.line(40, 0);
  const auto& moves = contour.motions();
  REQUIRE(moves.size() == 5);
  // The entry runs along X, left of it is Y; the first edge turns left into an inner corner.
  check_line(moves[0], {-3, 3, 0}, 1);
  check_line(moves[1], {-3, 20, 0}, 2);
  check_arc(moves[2], {0, 23, 0}, 0, 20, -1, 3);
  CHECK(moves[2].feed_mm_min == 300);
  check_line(moves[3], {20, 23, 0}, 3);
  check_line(moves[4], {40, 0, 0}, 4);
  CHECK_FALSE(contour.compensation().active());
}

TEST_CASE("an inner corner is cut short where the offsets meet", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-10, 0, 0});
  contour.line(0, 0);
  contour.line(20, 0);
  SECTION("of two lines: back by r tan(turn / 2)") {
    const double turn = std::numbers::pi / 3;
    contour.line(20 + 10 * std::cos(turn), 10 * std::sin(turn));
    check_line(contour.motions().at(1), {20 - 2 * std::tan(turn / 2), 2, 0}, 2);
  }
  SECTION("before an arc inside of which the tool runs") {
    // Radius 10 about (20, 10) would be tangent; about (14, 8) the contour kinks inwards.
    contour.arc(14, 18, 14, 8, 1);
    // The path beside it has radius 8: at the height of 2 it starts at 14 + sqrt(64 - 36).
    check_line(contour.motions().at(1), {14 + std::sqrt(28.0), 2, 0}, 2);
  }
  SECTION("before an arc that the tool goes round") {
    // A bump of radius 5 about (25, 0), passed above: the path beside it has radius 7.
    contour.arc(30, 0, 25, 0, -1);
    check_line(contour.motions().at(1), {25 - std::sqrt(45.0), 2, 0}, 2);
  }
}

TEST_CASE("an inner corner behind an arc mirrors the one before it", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-10, 0, 0});
  contour.line(0, 0);
  SECTION("of a bump that the tool goes round") {
    contour.arc(10, 0, 5, 0, -1);
    contour.line(30, 0);
    contour.compensation().flush();
    check_arc(contour.motions().at(1), {5 + std::sqrt(45.0), 2, 0}, 5, 0, -1, 2);
    check_line(contour.motions().at(2), {30, 2, 0}, 3);
  }
  SECTION("of a pocket's round end that the tool runs inside of") {
    // From (0, 0) counter-clockwise about (0, 10) to its top, then down through the middle.
    contour.arc(0, 20, 0, 10, 1);
    contour.line(0, 12);
    contour.compensation().flush();
    // 2 right of the line, on the circle of radius 8.
    check_arc(contour.motions().at(1), {2, 10 + std::sqrt(60.0), 0}, 0, 10, 1, 2);
  }
}

TEST_CASE("two bumps meet where the circles beside them do", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-10, 0, 0});
  contour.line(0, 0);
  contour.arc(10, 0, 5, 0, -1);
  contour.arc(20, 0, 15, 0, -1);
  contour.compensation().flush();
  // Radius 7 about centres 10 apart.
  check_arc(contour.motions().at(1), {10, std::sqrt(24.0), 0}, 5, 0, -1, 2);
  check_arc(contour.motions().at(2), {22, 0, 0}, 15, 0, -1, 3);
}

TEST_CASE("a reversal goes round its end, or stays above the bump that it comes from",
          "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-10, 0, 0});
  contour.line(0, 0);
  SECTION("behind a line") {
    contour.line(-10, 0);
    check_arc(contour.motions().at(1), {0, -2, 0}, 0, 0, -1, 2);
  }
  SECTION("behind a bump, up a wall") {
    contour.arc(10, 0, 5, 0, -1);
    contour.line(10, 30);
    check_arc(contour.motions().at(1), {8, std::sqrt(40.0), 0}, 5, 0, -1, 2);
  }
  SECTION("behind a pocket's round end") {
    contour.arc(10, 10, 0, 10, 1);
    contour.line(10, 0);
    check_arc(contour.motions().at(2), {12, 10, 0}, 10, 10, -1, 3);
  }
}

TEST_CASE("moves along the normal end over the corner that is cut short", "[unit][compensation]") {
  CompensatedContour contour(GENERATE(ArcPlane::xy, ArcPlane::zx));
  contour.begin(CompensationSide::right, 2, contour.point(-10, 0, 5));
  contour.line(0, 0, 5);
  contour.line(20, 0, 5);
  contour.line(20, 0, 9);
  contour.rapid(20, 0, 1);
  CHECK(contour.compensation().waiting() == 3);
  contour.line(20, -20, 1);
  const auto& moves = contour.motions();
  REQUIRE(moves.size() == 4);
  check_point(moves[1].to, contour.point(18, -2, 5));
  check_point(moves[2].to, contour.point(18, -2, 9));
  check_point(moves[3].to, contour.point(18, -2, 1));
  CHECK(moves[3].kind == MotionKind::rapid);
}

TEST_CASE("a rapid goes straight across an outer corner", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::right, 2, {-10, 0, 0});
  contour.line(0, 0);
  contour.rapid(0, 10);
  contour.compensation().flush();
  const auto& moves = contour.motions();
  REQUIRE(moves.size() == 3);
  check_line(moves[0], {0, -2, 0}, 1);
  CHECK((moves[1].kind == MotionKind::rapid && moves[2].kind == MotionKind::rapid));
  check_point(moves[1].to, {2, 0, 0});
  check_point(moves[2].to, {2, 10, 0});
}

TEST_CASE("an entry arc gets a radius that ends beside the contour", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {0, 0, 8});
  contour.arc(10, 10, 0, 10, 1, 6);
  contour.compensation().flush();
  REQUIRE(contour.motions().size() == 1);
  // Ends at (8, 10) with its centre at that height, equally far from (0, 0): (c - 8)^2 = c^2 + 100.
  check_arc(contour.motions()[0], {8, 10, 6}, -2.25, 10, 1, 1);
}

TEST_CASE("a negative radius is the other side", "[unit][compensation]") {
  CompensatedContour left, right;
  left.begin(CompensationSide::left, -3, {-10, 0, 0});
  right.begin(CompensationSide::right, 3, {-10, 0, 0});
  for (CompensatedContour* contour : {&left, &right}) {
    contour->line(0, 0);
    contour->line(20, 5);
    contour->compensation().end();
  }
  // The turn to the left is an outer corner on the right.
  REQUIRE(left.motions().size() == 3);
  for (int i = 0; i < 3; ++i) CHECK(left.motions()[i].to == right.motions()[i].to);
  check_point(left.motions()[0].to, {0, -3, 0});
}

TEST_CASE("a radius of 0 lets every motion through", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 0, {});
  contour.line(0, 0, -5);
  contour.arc(10, 0, 5, 0, 1);
  CHECK(contour.compensation().active());
  contour.compensation().end();
  contour.arc(0, 0, 5, 0, 1);
  CHECK(contour.compensation().idle());
  REQUIRE(contour.motions().size() == 3);
  CHECK(contour.motions()[0].to == Vec3{0, 0, -5});
}

TEST_CASE("a stop lets out what waits, and the tool goes on from there", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-10, 0, 0});
  contour.line(0, 0);
  contour.line(20, 0);
  contour.compensation().flush();
  CHECK(contour.motions().size() == 2);
  contour.line(20, 20);
  contour.compensation().end();
  // Into the inner corner uncut, as LinuxCNC does behind M0.
  check_line(contour.motions()[1], {20, 2, 0}, 2);
  check_line(contour.motions()[2], {18, 20, 0}, 3);
}

TEST_CASE("turns by less than 0.05 radians are smooth", "[unit][compensation]") {
  const double turn = GENERATE(0.049, -0.049, 0.051, -0.051);
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-10, 0, 0});
  contour.line(0, 0);
  contour.line(10 * std::cos(turn), 10 * std::sin(turn));
  contour.compensation().end();
  const bool outer = turn<-0.05, inner = turn> 0.05;
  CHECK(contour.motions().size() == (outer ? 3U : 2U));
  check_point(contour.motions()[0].to, {inner ? -2 * std::tan(turn / 2) : 0, 2, 0});
}

TEST_CASE("what compensation cannot begin with", "[unit][compensation]") {
  CompensatedContour contour;
  CHECK_THROWS_AS(contour.compensation().begin(CompensationSide::left, 1, ArcPlane::yz, {}),
                  std::invalid_argument);
  contour.begin(CompensationSide::left, 1, {});
  CHECK_THROWS_AS(contour.begin(CompensationSide::left, 1, {}), std::logic_error);
}

TEST_CASE("moves without end at one point are refused", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 1, {});
  contour.line(10, 0);
  // The entry waits too.
  for (std::size_t i = 1; i < CompensationQueue::kMostWaiting; ++i) contour.line(10, 0, 1);
  CHECK(contour.compensation().waiting() == CompensationQueue::kMostWaiting);
  CHECK(message_of<InputError>([&] { contour.line(10, 0, 2); }) ==
        "contour.ngc:1000001:1: error: more than 1000000 moves at one point of a contour with "
        "cutter compensation; expected a move along the contour");
}
