// Cutter compensation of controls that do not do as LinuxCNC does.
#include <cmath>

#include "tests/model/gcode/compensated_contour.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

TEST_CASE("Fanuc enters beside what comes next and goes round corners by lines",
          "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 3, {-20, 0, 0}, CompensationStyle::fanuc);
  contour.line(0, 0);
  contour.line(0, 0, -5);
  contour.line(0, 20, -5);
  contour.line(20, 20, -5);
  // Back at 45 degrees to the way it came: 3 mm beyond either end, and across.
  contour.line(10, 10, -5);
  contour.compensation().end();
  contour.line(40, 0, -5);
  const auto& moves = contour.motions();
  REQUIRE(moves.size() == 7);
  check_line(moves[0], {-3, 0, 0}, 1);
  check_line(moves[1], {-3, 0, -5}, 2);
  check_line(moves[2], {-3, 23, -5}, 3);
  check_line(moves[3], {23, 23, -5}, 4);
  const double s = 3 / std::sqrt(2.0);
  check_line(moves[4], {20 + 2 * s, 20, -5}, 5);
  check_line(moves[5], {10 + s, 10 - s, -5}, 5);
  check_line(moves[6], {40, 0, -5}, 6);
}

TEST_CASE("Fanuc's lines lead to arcs and away from them", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-20, 10, 0}, CompensationStyle::fanuc);
  // Entered outside of the corner: square to what comes next as well.
  contour.line(0, 0);
  contour.line(10, 0);
  // Inside along a half circle that begins downwards and ends upwards.
  contour.arc(18, 0, 14, 0, 1);
  contour.line(30, 0);
  contour.compensation().end();
  contour.line(40, 0);
  const auto& moves = contour.motions();
  REQUIRE(moves.size() == 7);
  check_line(moves[0], {0, 2, 0}, 1);
  check_line(moves[1], {12, 2, 0}, 2);
  check_line(moves[2], {12, 0, 0}, 3);
  check_arc(moves[3], {16, 0, 0}, 14, 0, 1, 3);
  check_line(moves[4], {16, 2, 0}, 4);
  check_line(moves[5], {30, 2, 0}, 4);
  check_line(moves[6], {40, 0, 0}, 5);
}

TEST_CASE("a wedge that is almost closed has no way round its tip inside", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 2, {-20, 0, 0}, CompensationStyle::fanuc);
  contour.line(0, 0);
  contour.line(100, 0);
  // 2.2 degrees between the sides: the paths meet 103 mm before the tip.
  CHECK_THROWS_WITH(contour.line(0, 3.9), ContainsSubstring("too short for the cutter"));
  CompensatedContour room;
  room.begin(CompensationSide::left, 2, {-20, 0, 0}, CompensationStyle::fanuc);
  room.line(0, 0);
  room.line(100, 0);
  room.line(0, 4.2);
  room.compensation().end();
  REQUIRE(room.motions().size() == 3);
  const double angle = std::atan2(4.2, 100);
  // A tangent of a small angle loses two digits.
  CHECK(distance(room.motions()[1].to, {100 - 2 / std::tan(angle / 2), 2, 0}) < 1e-10);
}

TEST_CASE("slight bends are corners too where they are exact", "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 10, {-20, 0, 0}, CompensationStyle::fanuc);
  contour.line(0, 0);
  contour.line(10, 0);
  contour.line(20, -0.2);
  contour.line(30, 0);
  contour.line(40, 0);
  contour.compensation().end();
  contour.line(50, 0);
  const auto& moves = contour.motions();
  const double half = std::atan2(0.2, 10) / 2;
  REQUIRE(moves.size() == 6);
  check_line(moves[1], {10 + 10 * std::tan(half), 10, 0}, 2);
  check_line(moves[2], {20, -0.2 + 10 / std::cos(2 * half), 0}, 3);
  check_line(moves[3], {30 - 10 * std::tan(half), 10, 0}, 4);
}

TEST_CASE("Siemens enters beside what comes next and goes round corners by arcs",
          "[unit][compensation]") {
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 3, {-20, 0, 0}, CompensationStyle::siemens);
  contour.line(0, 0);
  contour.line(0, 20);
  contour.line(20, 20);
  contour.compensation().end();
  contour.line(40, 0);
  const auto& moves = contour.motions();
  REQUIRE(moves.size() == 5);
  check_line(moves[0], {-3, 0, 0}, 1);
  check_line(moves[1], {-3, 20, 0}, 2);
  check_arc(moves[2], {0, 23, 0}, 0, 20, -1, 3);
  check_line(moves[3], {20, 23, 0}, 3);
}

TEST_CASE("after G40 the tool stays beside the contour until it moves in the plane",
          "[unit][compensation]") {
  const auto cut = [](CompensationStyle style) {
    CompensatedContour contour;
    contour.begin(CompensationSide::left, 3, {-20, 0, 0}, style);
    contour.line(0, 0);
    contour.line(0, 20);
    contour.compensation().end();
    contour.rapid(0, 20, 9);
    CHECK(contour.compensation().idle() == (style == CompensationStyle::linuxcnc));
    contour.rapid(0, 20, 10);
    contour.rapid(5, 20, 10);
    CHECK(contour.compensation().idle());
    REQUIRE(contour.motions().size() == 5);
    return contour.motions();
  };
  for (const auto style : {CompensationStyle::fanuc, CompensationStyle::siemens}) {
    const auto moves = cut(style);
    check_point(moves[2].to, {-3, 20, 9});
    check_point(moves[3].to, {-3, 20, 10});
    check_point(moves[4].to, {5, 20, 10});
  }
  check_point(cut(CompensationStyle::linuxcnc)[2].to, {0, 20, 9});
  // A place that is named is gone to, the contour's end too.
  CompensatedContour contour;
  contour.begin(CompensationSide::left, 3, {-20, 0, 0}, CompensationStyle::fanuc);
  contour.line(0, 0);
  contour.line(0, 20);
  contour.compensation().end();
  contour.compensation().name_place();
  contour.line(0, 20);
  check_point(contour.motions().back().to, {0, 20, 0});
  CHECK(contour.compensation().idle());
}

TEST_CASE("an entry that is square to what comes next may be short, and is straight",
          "[unit][compensation]") {
  for (const auto style : {CompensationStyle::fanuc, CompensationStyle::siemens}) {
    CompensatedContour contour;
    contour.begin(CompensationSide::left, 3, {-1, 0, 0}, style);
    contour.line(-1, 0, -2);  // no way in the plane: it enters nothing
    contour.line(0, 0, -2);
    contour.line(0, 20, -2);
    contour.compensation().end();
    REQUIRE(contour.motions().size() == 3);
    check_line(contour.motions()[0], {-1, 0, -2}, 1);
    check_line(contour.motions()[1], {-3, 0, -2}, 2);
    CompensatedContour arc;
    arc.begin(CompensationSide::left, 3, {-10, 0, 0}, style);
    CHECK_THROWS_WITH(arc.arc(0, 10, 0, 0, -1), ContainsSubstring("an arc as the entry"));
  }
}

TEST_CASE("Fanuc's contour behind two blocks without a motion in its plane is refused",
          "[unit][compensation]") {
  MachineSetup machine;
  machine.control = Control::fanuc;
  machine.assume_fresh_machine = true;
  machine.tools = {{1, 50, 8}};
  const std::string start = "G90 G21 G17 G40 T1 M6\nG43 H1 G0 X-26. Y-16. Z5.\nG41 D1 X-10.\n";
  const auto error = [&](const std::string& text, double diameter_mm = 8) {
    machine.tools[0].diameter_mm = diameter_mm;
    return error_of(start + text + "G40 X-26. Y-16.\nM30\n", machine);
  };
  CHECK(error("Z2.\nG1 Z-2. F300.\nY10.\n")
            .find("6:1: error: a motion under G41 or G42 behind more blocks") == 0);
  CHECK(error("G1 Z-2. F300.\nM8\n(a remark)\nS900\nG2 X0. Y0. R20.\n")
            .find("8:1: error: a motion under G41 or G42 behind more blocks") == 0);
  CHECK(error("G1 Y10. F300.\nM8\nG91 X0.\nG90 X10.\n").find("7:5: error: a motion under") == 0);
  CHECK(error("G1 Y10. F300.\nG91 X0.\nG90 X10.\n").find("6:5: error: a motion under") == 0);
  CHECK(error("G1 Y10. F300.\nY10.\nX10.\n").find("6:1: error: a motion under") == 0);
  CHECK(error("G1 Y10. F300.\nM1\nX10.\n").find("6:1: error: a motion under") == 0);
  // One may stand between, and remarks, settings of variables and blocks behind the last motion do
  // not count.
  CHECK(error("G1 Z-2. F300.\nY10.\nM8\nX10.\n") == "no error");
  CHECK(error("G1 Z-2. F300.\n(one)\n(two)\n#100=1\nY10.\n") == "no error");
  CHECK(error("G1 Z-2. F300.\nY10.\nZ5.\nM9\n") == "no error");
  CHECK(error("Z2.\nG1 Z-2. F300.\nY10.\n", 0) == "no error");
  machine.control = Control::haas;
  CHECK(error("Z2.\nG1 Z-2. F300.\nY10.\n") == "no error");
}
