#include "model/part/measured_points.h"

#include "model/base/error.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_measured_points(text, "p.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

bool starts(const std::string& text, const std::string& begin) {
  INFO(text);
  return text.rfind(begin, 0) == 0;
}

}  // namespace

TEST_CASE("measured points in each form of table", "[unit][measured_points]") {
  for (const char* text :
       {"x,y,z,u_mm\n1,2,3.5,0.001\n-1,0,2e1,0.002\n", "x;y;z;u_mm\n1;2;3.5;0.001\n-1;0;2e1;0.002",
        "\xEF\xBB\xBFX_mm, Y_mm ,Z_MM,U_mm\r\n1,2,3.5,0.001\r\n\r\n-1,0,+20,0.002\r\n\r\n",
        "  x y\tz   u_mm\n1 2 3.5 0.001\n  -1\t0 20 0.002  \n",
        "\"u_mm\",\"z\",\"y\",\"x\"\n\"0.001\",3.5,2,1\n0.002,20,0,-1\n"}) {
    INFO(text);
    const MeasuredPoints read = parse_measured_points(text, "p.csv");
    REQUIRE(read.points.size() == 2);
    CHECK(read.has_uncertainty);
    CHECK(read.ignored.empty());
    CHECK(read.points[0].at_mm == Vec3{1, 2, 3.5});
    CHECK(read.points[0].u_mm == 0.001);
    CHECK(read.points[0].line == 2);
    CHECK(read.points[1].at_mm == Vec3{-1, 0, 20});
    CHECK(read.points[1].u_mm == 0.002);
  }
  const MeasuredPoints more = parse_measured_points("id,x,y,z,nx\n\"A, 1\",1,2,3,\n", "p.csv");
  CHECK_FALSE(more.has_uncertainty);
  CHECK(more.points[0].u_mm == 0);
  CHECK(more.ignored == std::vector<std::string>{"id", "nx"});
}

TEST_CASE("what is no table of points is refused with its place", "[unit][measured_points]") {
  CHECK(starts(refusal(""), "p.csv: error: is empty"));
  CHECK(starts(refusal("\xEF\xBB\xBF\n\n"), "p.csv: error: is empty"));
  CHECK(starts(refusal("x,y,z\n"), "p.csv: error: has no points"));
  CHECK(starts(refusal("1,2,3\n4,5,6\n"), "p.csv:1:1: error: is no header"));
  CHECK(starts(refusal("\nx,y\n1,2\n"), "p.csv:2:1: error: has no column z"));
  CHECK(starts(refusal("x,y,z,x_mm\n1,2,3,4\n"), "p.csv:1:7: error: column 'x_mm' stands there"));
  CHECK(starts(refusal("x,y,z\n1,2\n"), "p.csv:2:3: error: 2 cells; expected 3"));
  CHECK(starts(refusal("x y z\n1 2 3\n1 2 3 4\n"), "p.csv:3:7: error: 4 cells"));
  CHECK(starts(refusal("x,y,z\n1,nan,3\n"), "p.csv:2:3: error: y: 'nan' is no number"));
  CHECK(starts(refusal("x,y,z\n1,2, inf\n"), "p.csv:2:6: error: z: 'inf' is no number"));
  CHECK(starts(refusal("x,y,z\n1,,3\n"), "p.csv:2:3: error: y is missing"));
  CHECK(starts(refusal("x;y;z\n1;2,5;3\n"), "p.csv:2:3: error: y: '2,5' is no number"));
  CHECK(starts(refusal("x,y,z\n1,2,12000\n"), "p.csv:2:5: error: z = 12000 mm"));
  for (const char* u : {"0", "-1", "1e-9", "1e9"})
    CHECK(starts(refusal(std::string("x,y,z,u_mm\n1,2,3,0.1\n1,2,3,") + u + "\n"),
                 "p.csv:3:7: error: u_mm = "));
  CHECK(starts(refusal("x,y,z,u_mm\n1,2,3,\n"), "p.csv:2:7: error: u_mm is missing"));
  CHECK(starts(refusal(std::string("\xEF\xBB\xBFx,y,q\n1,2,3\n")), "p.csv:1:4: error: has no"));
}

}  // namespace limitgauge::model
