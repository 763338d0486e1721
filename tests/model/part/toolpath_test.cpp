#include "model/part/toolpath.h"

#include "tests/support/catch.h"

using namespace limitgauge::model;

TEST_CASE("lengths and time of a path", "[unit][toolpath]") {
  Toolpath path;
  path.start = {0, 0, 10};
  path.moves = {{{30, 40, 10}, 0, 1, MoveKind::rapid},
                {{30, 40, 0}, 60, 2, MoveKind::feed},
                {{33, 44, 0}, 300, 3, MoveKind::feed}};
  const ToolpathLengths sum = lengths(path, 6000);
  CHECK(sum.rapid_mm == 50);
  CHECK(sum.cut_mm == 15);
  // 50 mm at 100 mm/s, 10 mm at 1 mm/s, 5 mm at 5 mm/s.
  CHECK(sum.time_s == Approx(0.5 + 10 + 1));
  CHECK(move_from(path, 0) == Vec3{0, 0, 10});
  CHECK(move_from(path, 2) == Vec3{30, 40, 0});
}

TEST_CASE("moves without a rate take no time", "[unit][toolpath]") {
  Toolpath path;
  path.moves = {{{1, 0, 0}, 0, 1, MoveKind::feed}, {{2, 0, 0}, 0, 2, MoveKind::rapid}};
  CHECK(lengths(path, 0).time_s == 0);
  CHECK(lengths(Toolpath{}, 1).cut_mm == 0);
}
