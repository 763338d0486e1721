#include <algorithm>
#include <cmath>

#include "tests/e2e/probe/probed_part.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using model::Vec3;
using nlohmann::json;
namespace {

constexpr double kU_mm = 3e-4;

/// The shift that comes back, each axis determined.
Vec3 shift_of(const json& result) {
  Vec3 shift;
  for (int axis = 0; axis < 3; ++axis) {
    INFO(result["shift"]);
    REQUIRE(result["shift"]["axes"][axis]["determined"] == true);
    shift[axis] = result["shift"]["axes"][axis]["shift_mm"].get<double>();
  }
  return shift;
}

TEST_CASE("a planted shift of 5 µm comes back within 0.1 µm from 200 points", "[e2e][probe]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  const std::vector<SurfacePoint> points = part_points(200);
  for (const Vec3& planted : {Vec3{0.003, -0.004, 0}, Vec3{0.005, 0, 0}, Vec3{0, 0, -0.005},
                              Vec3{-0.0029, 0.0029, 0.0029}, Vec3{0, 0, 0}}) {
    CAPTURE(planted.x, planted.y, planted.z);
    write_text(scratch / "points.csv", measured_table(points, planted, kU_mm));
    const Outcome outcome = probe(scratch, "part", "out", {"--force"});
    INFO(outcome.out << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    const json result = probe_json(scratch, "out");
    const Vec3 shift = shift_of(result);
    for (int axis = 0; axis < 3; ++axis) {
      const double off = std::abs(shift[axis] - planted[axis]);
      CHECK(off < 1e-4);
      // The stated uncertainty holds what is wrong, four times over at the most.
      CHECK(off < 4 * result["shift"]["axes"][axis]["u_mm"].get<double>());
    }
    CHECK(result["shift"]["settled"] == true);
    CHECK(result["shift"]["scatter_ratio"].get<double>() == Approx(1).margin(0.2));
    CHECK(result["after"]["rms_mm"].get<double>() == Approx(kU_mm).epsilon(0.2));
  }
  // Without noise nothing is left but the digits of the table.
  const Vec3 planted{0.003, -0.004, 0.0007};
  write_text(scratch / "points.csv", measured_table(points, planted, 0, false));
  REQUIRE(probe(scratch, "part", "out", {"--force"}).exit_code == 0);
  CHECK(distance(shift_of(probe_json(scratch, "out")), planted) < 1e-8);
}

TEST_CASE("residuals are those of closed forms, and lie in their intervals", "[e2e][probe]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  // Two above the floor, one within it; in the groove's air and material; on the raw block's side.
  write_text(scratch / "points.csv",
             "x,y,z\n20,10,-2.99\n20,10,-2.5\n20,10,-3.25\n25,20,-4.9\n25,20,-5.2\n50.01,20,-9\n");
  const Outcome outcome = probe(scratch, "part/result.json", "out");
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json result = probe_json(scratch, "out");
  const double expected[] = {0.01, 0.5, -0.25, 0.1, -0.2, 0.01};
  REQUIRE(result["worst"].size() == 6);
  for (const json& point : result["worst"]) {
    CAPTURE(point.dump());
    const int line = point["file_line"];
    const double truth = expected[line - 2];
    CHECK(point["residual"]["value_mm"].get<double>() == Approx(truth).margin(1e-9));
    CHECK(point["residual"]["low_mm"] <= truth);
    CHECK(point["residual"]["high_mm"] >= truth);
    CHECK(point["residual"]["high_mm"].get<double>() - point["residual"]["low_mm"].get<double>() <
          1e-6);
    if (line == 7) CHECK(point["made_by"] == "raw stock");
    if (line == 5 || line == 6) CHECK(point["program_line"] == 19);
    if (line == 5 || line == 6) CHECK(point["stage"] == "T2");
  }
}

TEST_CASE("points of a floor alone say nothing of X and Y", "[e2e][probe]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  write_text(scratch / "points.csv",
             measured_table(floor_points(200), {0.003, 0.004, -0.005}, kU_mm));
  const Outcome outcome = probe(scratch, "part", "out");
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("X undetermined, Y undetermined, Z -") &&
                              ContainsSubstring("no point lies on a surface that faces X"));
  const json axes = probe_json(scratch, "out")["shift"]["axes"];
  for (const int axis : {0, 1}) {
    CHECK(axes[axis]["determined"] == false);
    CHECK_FALSE(axes[axis].contains("shift_mm"));
  }
  CHECK(axes[2]["shift_mm"].get<double>() == Approx(-0.005).margin(1e-4));
}

TEST_CASE("points are held against the stock after the stage asked for", "[e2e][probe]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  write_text(scratch / "points.csv", "x y z\n25 20 -5\n25 10 -3\n");
  REQUIRE(probe(scratch, "part", "first", {"--stage", "T1"}).exit_code == 0);
  const json first = probe_json(scratch, "first");
  CHECK(first["stage"] == "T1");
  CHECK(first["stages"].size() == 1);
  CHECK(first["before"]["worst"]["residual"]["value_mm"].get<double>() == Approx(-2).margin(1e-9));
  REQUIRE(probe(scratch, "part", "last").exit_code == 0);
  CHECK(probe_json(scratch, "last")["before"]["rms_mm"].get<double>() < 1e-9);
}

TEST_CASE("the chords of arcs widen the intervals", "[e2e][probe]") {
  const Scratch scratch;
  write_text(scratch / "ring.ngc",
             "G21 G90 G17\nM3 S8000\nG0 Z5\nG0 X10 Y0\nG1 Z-2 F300\nG2 X10 Y0 I-10 J0\nG0 Z5\n"
             "M5\nM30\n");
  REQUIRE(limitgauge(scratch, {"cut", "--stock", "box:40,40,10@-20,-20,-10", "--tool",
                               "flat:D=4,L=10", "--program", "ring.ngc", "--voxel", "0.5",
                               "--no-pictures", "--quiet", "-o", "ring"})
              .exit_code == 0);
  // On the ring's outer wall, whose radius is 12, a little into the air and into the material.
  std::string table = "x,y,z\n";
  for (int i = 0; i < 60; ++i) {
    const double turn = 0.1 * i, radius = i % 2 == 0 ? 11.999 : 12.001;
    table += std::to_string(radius * std::cos(turn)) + "," +
             std::to_string(radius * std::sin(turn)) + ",-1\n";
  }
  write_text(scratch / "points.csv", table);
  REQUIRE(probe(scratch, "ring", "out").exit_code == 0);
  const json result = probe_json(scratch, "out");
  CHECK(result["stages"][0]["chord_error_mm"].get<double>() > 0);
  for (const json& point : result["worst"]) {
    CAPTURE(point.dump());
    const Vec3 at{point["at_mm"][0], point["at_mm"][1], 0};
    const double truth = 12 - length(at);
    CHECK(point["residual"]["low_mm"] <= truth);
    CHECK(point["residual"]["high_mm"] >= truth);
  }
}

TEST_CASE("a limit for the residuals passes, fails or stays open", "[e2e][probe]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  write_text(scratch / "points.csv", "x,y,z,u_mm\n20,10,-2.99,0.001\n22,12,-3.002,0.001\n");
  CHECK(probe(scratch, "part", "out").exit_code == 0);
  CHECK(probe(scratch, "part", "out", {"--force", "--residual", "0.013"}).exit_code == 0);
  CHECK(probe(scratch, "part", "out", {"--force", "--residual", "0.011"}).exit_code == 2);
  const Outcome failed = probe(scratch, "part", "out", {"--force", "--residual", "0.007"});
  CHECK(failed.exit_code == 1);
  CHECK_THAT(failed.out, ContainsSubstring("residual limit 7 µm: fail, 1 beyond"));
  CHECK(probe_json(scratch, "out")["gate"]["verdict"] == "fail");
  const Outcome told = probe(scratch, "part", "told", {"--json", "--residual", "0.007"});
  CHECK(told.exit_code == 1);
  CHECK(told.out == read_text(scratch / "told/probe.json"));
}

TEST_CASE("the same points give the same bytes for any number of threads", "[e2e][probe]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  write_text(scratch / "points.csv", measured_table(part_points(1500), {0.003, -0.004, 0}, kU_mm));
  REQUIRE(probe(scratch, "part", "one", {"--threads", "1"}).exit_code == 0);
  REQUIRE(probe(scratch, "part", "two", {"--threads", "2"}).exit_code == 0);
  for (const char* name : {"probe.html", "probe.csv", "probe.json"})
    CHECK(read_text(scratch / "one" / name) == read_text(scratch / "two" / name));
}

TEST_CASE("a probe that is interrupted leaves nothing", "[e2e][probe][stop]") {
  const Scratch scratch;
  cut_part(scratch, "part");
  // Some seconds of work.
  write_text(scratch / "points.csv", measured_table(part_points(400'000), {}, kU_mm));
  const std::vector<std::string> before = scratch.entries();
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = limitgauge(scratch, {"probe", "part", "points.csv", "-o", "out"},
                                     {std::chrono::milliseconds(1200), std::nullopt});
  CHECK(outcome.exit_code == 4);
  // On an idle machine within two seconds of the signal.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(11));
  CHECK(scratch.entries() == before);
}

}  // namespace
}  // namespace limitgauge::e2e
