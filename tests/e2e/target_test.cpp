// A mesh as the design, from the command line and from a job.
#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

using nlohmann::json;

/// A level floor of 40 × 30 mm, four triangles round its middle.
std::string floor_stl() {
  const char* corners[] = {"0 0 0", "40 0 0", "40 30 0", "0 30 0"};
  std::string text = "solid floor\n";
  for (int k = 0; k < 4; ++k)
    text += std::string("facet normal 0 0 1\nouter loop\nvertex ") + corners[k] + "\nvertex " +
            corners[(k + 1) % 4] + "\nvertex 20 15 0\nendloop\nendfacet\n";
  return text + "endsolid floor\n";
}

/// Rows of a flat cutter over the floor at z 0, but for the one at y = 4, which is 30 µm deeper.
std::string rows() {
  std::string text = "G21 G90\nT1 M6\nS9000 M3\nG0 Z20\nG0 X-8 Y-4\nG1 Z0 F400\n";
  double x = 48;
  for (int y = -4; y <= 34; y += 4, x = 40 - x)
    text += "G1 Y" + std::to_string(y) + " Z" + (y == 4 ? "-0.03" : "0") + " F900\nG1 X" +
            std::to_string(x) + "\n";
  return text + "G0 Z20\nM30\n";
}

std::vector<std::string> verify_floor(const std::vector<std::string>& more) {
  std::vector<std::string> words = {"verify",        "--stock",      "box:40,30,8@0,0,-6", "--tool",
                                    "flat:D=8,L=20", "--program",    "rows.ngc",           "-o",
                                    "out",           "--no-pictures"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void write_floor(const Scratch& scratch) {
  write_text(scratch / "floor.stl", floor_stl());
  write_text(scratch / "rows.ngc", rows());
}

}  // namespace

TEST_CASE("verify measures against the facets of a mesh and names the triangle", "[e2e][target]") {
  const Scratch scratch;
  write_floor(scratch);
  const Outcome outcome = limitgauge(
      scratch, verify_floor({"--target", "floor.stl", "--gouge", "0.01", "--uncut", "0.01"}));
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 1);
  const json result = json::parse(read_text(scratch / "out/result.json"));
  const json& surface = result["surface"];
  CHECK(surface["mesh"] == "floor.stl");
  CHECK_FALSE(surface.contains("cage"));
  CHECK(surface["faces"] == 4);
  CHECK(surface["rules"]["scheme"] == "facets");
  CHECK(surface["witness"]["points"].get<int>() > 0);
  const json& deviation = result["stages"][0]["deviation"];
  const double low = deviation["gouge_mm"]["low"], high = deviation["gouge_mm"]["high"];
  CHECK(low <= 0.03 + 1e-9);
  CHECK(low > 0.029);
  CHECK(high >= 0.03 - 1e-9);
  CHECK(deviation["uncut_mm"]["high"].get<double>() <= 0.01);
  const json& worst = deviation["gouges"][0];
  CHECK(worst["triangle"].get<int>() >= 1);
  CHECK(worst["triangle"].get<int>() <= 4);
  CHECK(worst["line"].get<int>() > 0);
  const std::string page = read_text(scratch / "out/report.html");
  CHECK(page.find("all of this is about its facets") != std::string::npos);
  CHECK(page.find("triangle " + std::to_string(worst["triangle"].get<int>())) != std::string::npos);
}

TEST_CASE("a job with a mesh says the same as verify", "[e2e][target]") {
  const Scratch scratch;
  write_floor(scratch);
  REQUIRE(limitgauge(scratch,
                     verify_floor({"--target", "floor.stl", "--gouge", "0.05", "--uncut", "0.01"}))
              .exit_code == 0);
  write_text(scratch / "job.toml", R"(name = "floor"
[surface]
mesh = "floor.stl"
[stock]
shape = "box"
size = [40, 30, 8]
corner = [0, 0, -6]
[[tool]]
id = "flat8"
type = "flat"
diameter = 8
flute_length = 20
[[stage]]
name = "program"
tool = "flat8"
program = "rows.ngc"
[stage.gate]
gouge = 0.05
uncut = 0.01
)");
  const Outcome outcome = limitgauge(scratch, {"run", "job.toml", "-o", "run", "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const auto deviation = [&](const char* folder) {
    return json::parse(
        read_text(scratch / (std::string(folder) + "/result.json")))["stages"][0]["deviation"];
  };
  for (const char* key : {"gouge_mm", "uncut_mm", "coverage", "gouges"})
    CHECK(deviation("out")[key] == deviation("run")[key]);
}

TEST_CASE("what a design cannot be is said, with what would do", "[e2e][target]") {
  const Scratch scratch;
  write_floor(scratch);
  const auto refused = [&](const std::vector<std::string>& words, const std::string& part) {
    const Outcome outcome = limitgauge(scratch, words);
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.errors.find(part) != std::string::npos);
    CHECK(scratch.entries() == std::vector<std::string>{"floor.stl", "rows.ngc"});
  };
  refused(verify_floor({}), "--target (a triangle mesh)");
  refused(verify_floor({"--target", "floor.stl", "--cage", "floor.stl"}), "one of the two");
  refused(verify_floor({"--target", "no.stl"}), "no.stl");
  refused(verify_floor({"--target", "rows.ngc"}), "STL, OBJ or PLY");
  refused(verify_floor({"--cage", "floor.stl"}), "--target");
}

TEST_CASE("paths are planned on cages only", "[e2e][target]") {
  const Scratch scratch;
  write_floor(scratch);
  const Outcome outcome =
      limitgauge(scratch, {"run", fixture("jobs/quick-dome.toml"), "--set",
                           "surface={mesh=\"" + (scratch / "floor.stl").string() + "\"}"});
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.errors.find("the design is a mesh") != std::string::npos);
}

TEST_CASE("inspect says what a mesh is, and that a cage of triangles looks like one",
          "[e2e][target]") {
  const Scratch scratch;
  write_floor(scratch);
  const Outcome mesh = limitgauge(scratch, {"inspect", "floor.stl"});
  INFO(mesh.errors);
  REQUIRE(mesh.exit_code == 0);
  CHECK(mesh.out.find("triangles              4") != std::string::npos);
  CHECK(mesh.out.find("mesh area              1200.000000 mm2") != std::string::npos);
  std::string obj;
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 8; ++i) obj += "v " + std::to_string(i) + " " + std::to_string(j) + " 0\n";
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      const int a = 9 * j + i + 1, b = a + 1, c = a + 10, d = a + 9;
      for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}})
        obj += "f " + std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r) + "\n";
    }
  write_text(scratch / "plate.obj", obj);
  const Outcome cage = limitgauge(scratch, {"inspect", "plate.obj"});
  REQUIRE(cage.exit_code == 0);
  CHECK(cage.out.find("128 of its 128 faces are triangles") != std::string::npos);
  CHECK(cage.out.find("--target") != std::string::npos);
}

}  // namespace limitgauge::e2e
