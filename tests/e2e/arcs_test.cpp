// Programs with arcs along and about the walls of a box whose edges are sharp, as foreign CAM
// writes them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
using nlohmann::json;
namespace {

/// 12 x 10 x 4 mm, its top at z = 0. All edges are sharp, so that its limit surface is the box.
constexpr const char* kBox =
    "v -6 -5 -4\nv 6 -5 -4\nv -6 5 -4\nv 6 5 -4\nv -6 -5 0\nv 6 -5 0\nv -6 5 0\nv 6 5 0\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\n"
    "t crease 2/1/0 0 1 10\nt crease 2/1/0 0 2 10\nt crease 2/1/0 0 4 10\nt crease 2/1/0 1 3 10\n"
    "t crease 2/1/0 1 5 10\nt crease 2/1/0 2 3 10\nt crease 2/1/0 2 6 10\nt crease 2/1/0 3 7 10\n"
    "t crease 2/1/0 4 5 10\nt crease 2/1/0 4 6 10\nt crease 2/1/0 5 7 10\nt crease 2/1/0 6 7 10\n";

/// A flat of D4 faces the top, comes to the left wall by a roll of R3, goes along all walls with a
/// roll of R2 about each corner, and leaves as it came.
std::string contour(const std::string& right_wall) {
  return "G21 G90 G17\nS5000 M3 F1000\nG0 Z5\nG0 X-12 Y-4\n"
         "G1 Z0\nX9\nY-1\nX-9\nY2\nX9\nY5\nX-9\nG0 Z5\n"
         "G0 X-11 Y-3\nG1 Z-4\nG3 X-8 Y0 J3\n"
         "G1 Y5\nG2 X-6 Y7 I2\nG1 X6\nG2 X8 Y5 J-2\n" +
         right_wall + "\nG2 X6 Y-7 I-2\nG1 X-6\nG2 X-8 Y-5 J2\nG1 Y0\nG3 X-11 Y3 I-3\nG0 Z5\nM30\n";
}
constexpr int kRightWallLine = 21;

struct Verified {
  explicit Verified(const std::string& program) {
    write_text(scratch / "box.obj", kBox);
    write_text(scratch / "box.ngc", program);
    outcome =
        limitgauge(scratch, {"verify", "--cage", "box.obj", "--stock", "box:16,14,5@-8,-7,-4.5",
                             "--tool", "flat:D=4,L=8", "--program", "box.ngc", "--gouge", "0.05",
                             "--uncut", "0.1", "--voxel", "0.25", "-o", "out", "--no-pictures"});
    INFO(outcome.errors);
    REQUIRE(std::filesystem::exists(scratch / "out/result.json"));
    stage = json::parse(read_text(scratch / "out/result.json"))["stages"][0];
  }
  double figure(const char* name, const char* side) const {
    return stage["deviation"][name][side].get<double>();
  }

  Scratch scratch;
  Outcome outcome;
  json stage;
};

}  // namespace

TEST_CASE("arcs that roll round the corners of a box and along its walls pass", "[e2e][verify]") {
  const Verified flush(contour("G1 Y-5"));
  CHECK(flush.outcome.exit_code == 0);
  CHECK(flush.stage["verdict"] == "pass");
  CHECK(flush.figure("gouge_mm", "high") < 0.01);
  CHECK(flush.figure("uncut_mm", "high") < 0.01);
  CHECK(flush.stage["deviation"]["voxel_gouge_mm"].get<double>() < 0.01);
  // The stock is cut by the program's chords, and the report says by how much they are wider.
  CHECK(flush.stage["toolpath"]["chord_error_mm"].get<double>() > 1e-4);
  for (const json& term : flush.stage["deviation"]["uncertainty"])
    if (term["source"] == "arcs stood for by chords") CHECK(term["bound_mm"] <= 1e-6);
}

TEST_CASE("an arc that bulges into a wall gouges it by as much", "[e2e][verify]") {
  // Over 10 mm, 0.06 mm deep in its middle: gouge on the wall, and the rim of the top goes with it.
  constexpr double kDepth_mm = 0.06;
  const double radius = (25 + kDepth_mm * kDepth_mm) / (2 * kDepth_mm);
  const Verified bulged(contour("G3 Y-5 X8 R" + std::to_string(radius)));
  CHECK(bulged.outcome.exit_code == 1);
  CHECK(bulged.stage["verdict"] == "fail");
  CHECK(bulged.figure("gouge_mm", "low") > kDepth_mm - 0.005);
  bool named = false;
  for (const json& gouge : bulged.stage["deviation"]["gouges"])
    named = named || gouge["line"] == kRightWallLine;
  CHECK(named);
}

}  // namespace limitgauge::e2e
