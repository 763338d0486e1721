#include <cmath>
#include <functional>
#include <string>

#include "tests/model/fixture_files.h"
#include "tests/model/gcode/compensated_contour.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

namespace {

const std::string kFine = "no error";

/// What a cutter of radius 3 at (-10, 0), left of its contour, is refused with.
std::string compensation_error_of(const std::function<void(CompensatedContour&)>& cut) {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 3, {-10, 0, 0});
  return message_of<InputError>([&] { cut(contour); });
}

/// The same behind an entry along X to (0, 0).
std::string error_behind_entry(const std::function<void(CompensatedContour&)>& cut) {
  return compensation_error_of([&](CompensatedContour& contour) {
    contour.line(0, 0);
    cut(contour);
  });
}

std::string refusal(int line, const std::string& wrong, const std::string& expected) {
  return "contour.ngc:" + std::to_string(line) + ":1: error: " + wrong + "; expected " + expected;
}

}  // namespace

TEST_CASE("an entry must be longer than the radius", "[unit][compensation]") {
  const auto refused = [](const std::string& length) {
    return refusal(1,
                   "the entry into cutter compensation is " + length +
                       " long in its plane, the cutter's radius 3 mm",
                   "an entry longer than the radius");
  };
  CHECK(compensation_error_of([](auto& c) { c.line(-7, 0); }) == refused("3 mm"));
  CHECK(compensation_error_of([](auto& c) { c.line(-6.999, 0); }) == kFine);
  CHECK(compensation_error_of([](auto& c) { c.rapid(-10, 0, -5); }) == refused("0 mm"));
  CHECK(compensation_error_of([](auto& c) { c.arc(-8, 0, -9, 0, -1); }) == refused("2 mm"));
}

TEST_CASE("an entry arc that would become a straight line is refused", "[unit][compensation]") {
  // The tool ends 3 above the arc's lowest point, at the height that it starts from; the centre is
  // equally far from both: (y + 3)^2 = 10^2 + y^2.
  CHECK(compensation_error_of([](auto& c) { c.arc(0, -3, 0, 91.0 / 6, 1); }) ==
        refusal(1, "an entry arc that cutter compensation bends into a straight line",
                "an arc that starts away from the tangent beside its end"));
}

TEST_CASE("an arc is wider than the cutter inside it", "[unit][compensation]") {
  const std::string wrong =
      "an arc of 3 mm radius around the inside of which the cutter goes, whose radius is 3 mm";
  CHECK(compensation_error_of([](auto& c) { c.arc(-4, 0, -7, 0, 1); }) ==
        refusal(1, wrong, "an arc wider than the cutter"));
  CHECK(error_behind_entry([](auto& c) { c.arc(0, 6, 0, 3, 1); }) ==
        refusal(2, wrong, "an arc wider than the cutter"));
  CHECK(error_behind_entry([](auto& c) { c.arc(0, 6.002, 0, 3.001, 1); }) == kFine);
  CHECK(error_behind_entry([](auto& c) { c.arc(0, -6, 0, -3, -1); }) == kFine);
}

TEST_CASE("a straight move between inner corners needs room for the cutter",
          "[unit][compensation]") {
  const auto groove = [](double width_mm) {
    return error_behind_entry([width_mm](CompensatedContour& c) {
      c.line(0, width_mm);
      c.line(-20, width_mm);
    });
  };
  const std::string refused =
      refusal(2, "a straight move too short for the cutter in its inner corners",
              "inner corners that leave the cutter room");
  CHECK(groove(5.999) == refused);
  CHECK(groove(6.001) == kFine);
  // Nothing cuts a move short where G40 ends the contour; the corner at its start may.
  const auto last = [](double length_mm) {
    return error_behind_entry([length_mm](CompensatedContour& c) {
      c.rapid(0, length_mm);
      c.compensation().end();
    });
  };
  CHECK(last(2.999) == refused);
  CHECK(last(3.001) == kFine);
}

TEST_CASE("an arc between inner corners needs room for the cutter", "[unit][compensation]") {
  // A floor of 2 mm, as an arc of radius 20, between two walls. On the circle of radius 17 inside
  // it the cutter would go from 3 right of the first wall to 3 left of the second, which is
  // backwards, or 360 - asin(3 / 17) - asin(1 / 17) degrees.
  CHECK(error_behind_entry([](auto& c) {
          c.line(20, 0);
          c.line(20, -40);
          c.arc(22, -39.8998, 20, -20, 1);
          c.line(22, 0);
        }) ==
        refusal(4, "the cutter would have to turn 346.464 degrees along an arc of 5.73916 degrees",
                "smooth corners, or inner ones that leave the cutter room"));
}

TEST_CASE("an arc may turn LinuxCNC's slack further than programmed", "[unit][compensation]") {
  // A corner of 0.02 radians is smooth, so that the cutter stays where it ends beside the line, and
  // is 0.0035 radians before the place beside the arc's start.
  const auto kink = [](bool inches) {
    return error_behind_entry([inches](CompensatedContour& c) {
      c.compensation().use_inches(inches);
      const double turn = -0.02, c1 = -20 * std::sin(turn), c2 = 20 * std::cos(turn);
      c.arc(c1, c2 + 20, c1, c2, 1);
      c.compensation().end();
    });
  };
  CHECK(kink(false) == kFine);
  // Half a turn, 0.02 radians more as programmed, atan(20 sin 0.02 / (20 cos 0.02 - 3)) as cut.
  CHECK(kink(true) ==
        refusal(2, "the cutter would have to turn 181.348 degrees along an arc of 181.146 degrees",
                "smooth corners, or inner ones that leave the cutter room"));
}

TEST_CASE("neighbours whose offsets do not meet are refused", "[unit][compensation]") {
  const std::string expected = "a corner that the cutter fits into";
  CHECK(error_behind_entry([](auto& c) { c.arc(-7, 2, -3.5, 1, 1); }) ==
        refusal(2, "the cutter does not fit between the straight move before and this arc",
                expected));
  const auto pocket = [](CompensatedContour& c) { c.arc(4, 4, 0, 4, 1); };
  CHECK(error_behind_entry([&](auto& c) {
          pocket(c);
          c.line(-3, 4);
        }) == refusal(3, "the cutter does not fit between the arc before and this straight move",
                      expected));
  CHECK(error_behind_entry([&](auto& c) {
          pocket(c);
          c.arc(-6, 14, 4, 14, -1);
        }) == refusal(3, "the cutter does not fit between the arc before and this arc", expected));
  CHECK(error_behind_entry([&](auto& c) {
          pocket(c);
          c.arc(2, 6, 4, 6, -1);
        }) == kFine);
}

TEST_CASE("two arcs of one centre make no inner corner", "[unit][compensation]") {
  CHECK(error_behind_entry([](auto& c) {
          c.arc(5, 5, 0, 5, 1);
          c.arc(0, 0, 0, 5, -1);
        }) == refusal(3, "an inner corner between two arcs of one centre with cutter compensation",
                      "arcs about different centres"));
}

TEST_CASE("an arc right after compensation is refused", "[unit][compensation]") {
  const std::string refused =
      refusal(2, "an arc right after cutter compensation", "a straight move after G40");
  CHECK(error_behind_entry([](auto& c) {
          c.compensation().end();
          c.arc(10, 0, 5, 0, 1);
        }) == refused);
  CHECK(error_behind_entry([](auto& c) {
          c.compensation().end();
          c.begin(CompensationSide::left, 3, {0, 0, 0});
          c.arc(10, 0, 5, 0, 1);
        }) == refused);
  CHECK(error_behind_entry([](auto& c) {
          c.compensation().end();
          c.rapid(1, 0);
          c.arc(11, 0, 6, 0, 1);
        }) == kFine);
}

TEST_CASE("compensation is idle again behind the straight move that leaves",
          "[unit][compensation]") {
  CompensatedContour contour;
  CHECK(contour.compensation().idle());
  contour.begin(CompensationSide::left, 3, {-10, 0, 0});
  contour.line(0, 0);
  contour.compensation().end();
  CHECK_FALSE(contour.compensation().idle());
  contour.line(5, 5);
  CHECK(contour.compensation().idle());
}
