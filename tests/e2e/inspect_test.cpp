#include <cmath>
#include <map>
#include <sstream>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

std::vector<std::vector<double>> table_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  CHECK(line == "face,u,v,x,y,z,nx,ny,nz");
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

TEST_CASE("the aircraft measures what the paper's measures", "[e2e][inspect]") {
  const Scratch scratch;
  const Outcome outcome = limitgauge(scratch, {"inspect", fixture("cages/aircraft.obj")});
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("patches                29\n"));
  const std::string title = "limit surface size     ";
  std::istringstream size(outcome.out.substr(outcome.out.find(title) + title.size()));
  double x = 0, y = 0, z = 0;
  char times = 0;
  size >> x >> times >> y >> times >> z;
  // The cage's coordinates are rounded to 1e-6 mm.
  CHECK(x == Approx(81.2).margin(1e-5));
  CHECK(y == Approx(65.5).margin(1e-5));
  CHECK(z == Approx(11.6).margin(1e-5));
}

TEST_CASE("inspect writes reference points and normals", "[e2e][inspect]") {
  const Scratch scratch;
  const Outcome outcome = limitgauge(scratch, {"inspect", fixture("cages/quick-dome.obj"),
                                               "--samples", "5", "--csv", "points.csv"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(scratch.entries() == std::vector<std::string>{"points.csv"});
  const auto rows = table_of(read_text(scratch / "points.csv"));
  REQUIRE(rows.size() == 12 * 5 * 5);
  bool apex = false;
  for (const std::vector<double>& row : rows) {
    REQUIRE(row.size() == 9);
    CHECK(std::hypot(row[6], row[7], row[8]) == Approx(1).epsilon(1e-12));
    CHECK(row[8] > 0.8);
    CHECK(std::fmod(row[1], 0.25) == 0);
    // The dome is symmetric, so its top is level.
    if (std::hypot(row[3], row[4]) < 1e-9) {
      apex = true;
      CHECK(row[5] == Approx(4).margin(1e-5));
      CHECK(row[8] == Approx(1).epsilon(1e-9));
    }
  }
  CHECK(apex);
  CHECK(rows.front()[0] == 0);
  CHECK(rows.back()[0] == 11);
  // Samples take the place of samples, and a cage is one whatever the case of its name.
  write_text(scratch / "DOME.OBJ", read_text(fixture("cages/quick-dome.obj")));
  const Outcome again =
      limitgauge(scratch, {"inspect", "DOME.OBJ", "--samples", "2", "--csv", "points.csv"});
  CHECK(again.exit_code == 0);
  CHECK(table_of(read_text(scratch / "points.csv")).size() == 12 * 2 * 2);
}

// TURNS as LinuxCNC's canonical arcs count them: 1 is counter-clockwise up to one full circle.
TEST_CASE("inspect of an empty file is an error", "[e2e][inspect]") {
  const Scratch scratch;
  for (const char* file : {"e.ngc", "e.obj", "e.stl", "e.ply", "e"}) {
    write_text(scratch / file, "");
    const Outcome outcome = limitgauge(scratch, {"inspect", file});
    INFO(file << ": " << outcome.errors);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.errors, ContainsSubstring("expected a "));
  }
  write_text(scratch / "blank.ngc", " \r\n\n\t");
  CHECK_THAT(limitgauge(scratch, {"inspect", "blank.ngc"}).errors,
             ContainsSubstring("blank.ngc: error: the file is empty; expected a program"));
}

TEST_CASE("inspect refuses what a cage has no use for", "[e2e][inspect]") {
  const Scratch scratch;
  write_text(scratch / "a.tbl", "T1 P1 D6\n");
  write_text(scratch / "a.stl", "solid\nendsolid\n");
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--moves"},
                                                  {"--control", "fanuc"},
                                                  {"--work-offset", "G54=1,2,3"},
                                                  {"--home", "0,0,0"},
                                                  {"--second-home", "0,0,0"},
                                                  {"--start", "0,0,0"},
                                                  {"--tool-table", "a.tbl"},
                                                  {"--subprograms", "."}})
    for (const std::string& file : {fixture("cages/quick-dome.obj"), std::string("a.stl")}) {
      std::vector<std::string> arguments = {"inspect", file};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Outcome outcome = limitgauge(scratch, arguments);
      CHECK(outcome.exit_code == 3);
      CHECK_THAT(outcome.errors, ContainsSubstring(options[0] + " is for programs"));
    }
}

TEST_CASE("inspect lists canonical moves", "[e2e][inspect]") {
  const Scratch scratch;
  write_text(scratch / "a.ngc",
             "G21 G90 G17\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nG3 X10 Y10 I0 J5\nG20\nG0 Z1\nM30\n");
  const Outcome outcome = limitgauge(scratch, {"inspect", "a.ngc", "--moves"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out ==
        "2 rapid 0.000000 0.000000 5.000000\n"
        "3 feed 0.000000 0.000000 -1.000000\n"
        "4 feed 10.000000 0.000000 -1.000000\n"
        "5 arc 17 10.000000 10.000000 -1.000000 10.000000 5.000000 1\n"
        "7 rapid 10.000000 10.000000 25.400000\n");
}

}  // namespace
}  // namespace limitgauge::e2e
