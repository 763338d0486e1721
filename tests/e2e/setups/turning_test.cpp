// Programs whose tool turns as it cuts, made by fixtures/turning/post.py, whose surfaces and
// kinematics are its own: of each kind one that is right, and its twin with one rotary word wrong.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/e2e/program.h"
#include "tests/e2e/shell.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace limitgauge::e2e {
using nlohmann::json;
namespace {

/// Places `every` times as far apart as a finish has them, and gates wider by its square: in less
/// time by that.
std::string post(const Scratch& scratch, const std::string& name, int every,
                 const std::string& options) {
  const ShellOutcome outcome =
      bash("python3 '" + fixture("turning/post.py") + "' " + name + " '" + scratch.path().string() +
           "' --every " + std::to_string(every) + options);
  INFO(outcome.out);
  REQUIRE(outcome.exit_code == 0);
  return outcome.out;
}

Outcome run(const Scratch& scratch, const std::string& name) {
  return limitgauge(scratch,
                    {"run", name + ".toml", "-o", "out", "--force", "--no-pictures", "--quiet"});
}

json finish_of(const Scratch& scratch) {
  return json::parse(read_text(scratch / "out/result.json"))["stages"][0];
}

void passes(const std::string& name, const std::string& form = "") {
  const Scratch scratch;
  post(scratch, name, 2, form);
  const Outcome outcome = run(scratch, name);
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  const json finish = finish_of(scratch);
  CHECK(finish["verdict"] == "pass");
  // What rows so far apart must leave over: a ball's scallop, of 1 mm rows 40 um and more.
  CHECK(finish["deviation"]["uncut_mm"]["low"] > 0.04);
  CHECK(finish["simulation"]["findings"].empty());
}

/// The script says by how much more the ball goes in there: with the chords of a path as coarse as
/// this one that is what is found, within a tenth.
void fails_at_its_line(const std::string& name, int place) {
  const Scratch scratch;
  std::istringstream said(post(scratch, name, 4, " --wrong " + std::to_string(place)));
  int line = 0;
  double depth_mm = 0;
  REQUIRE(said >> line >> depth_mm);
  REQUIRE(depth_mm > 0.3);
  REQUIRE(run(scratch, name).exit_code == 1);
  const json finish = finish_of(scratch);
  CHECK(finish["verdict"] == "fail");
  const json& worst = finish["deviation"]["gouges"].at(0);
  CHECK(worst["line"] == line);
  CHECK(worst["depth_mm"].get<double>() == Approx(depth_mm).epsilon(0.1));
  // One bad word, one place: no other line goes anywhere near as deep.
  for (const json& gouge : finish["deviation"]["gouges"])
    if (gouge["depth_mm"] > 0.1) CHECK(std::abs(gouge["line"].get<int>() - line) <= 1);
}

/// A plate whose rim is flush with its block, and a row of a flat that leans by 5 degrees before it
/// turns: its heel goes in by 3 sin 5° - 0.05 mm.
constexpr double kHeel_mm = 0.2114672;
void write_heel(const Scratch& scratch) {
  write_text(scratch / "plate.obj",
             "v -10 -2 0\nv 10 -2 0\nv 10 2 0\nv -10 2 0\nf 1 2 3\nf 1 3 4\n");
  write_text(scratch / "heel.nc",
             "G21 G90 G94 G17 G40 G49\nT1 M6\nS8000 M3\nG43 H1\nG0 Z100\nG0 B5 C0\nG43.4 H1\n"
             "G0 X-20 Y0.3 Z30\nG1 Z0.05 F600\nG1 X20\nG1 X30 B6\nG0 Z60\nG49\nM5\nM30\n");
  write_text(scratch / "heel.toml", R"(name = "heel"
surface = { mesh = "plate.obj" }
stock = { shape = "box", size = [20, 8, 6], corner = [-10, -4, -4] }
simulation = { voxel = 0.25 }
[machine]
kinematics = "table-table"
control = "fanuc"
work_offsets = { G54 = [0, 0, 0] }
[[machine.axis]]
word = "B"
direction = [0, 1, 0]
point = [0, 0, -50]
limits = [-100, 100]
[[machine.axis]]
word = "C"
direction = [0, 0, 1]
point = [0, 0, 0]
limits = [-360, 360]
[[tool]]
id = "flat6"
number = 1
type = "flat"
diameter = 6
flute_length = 12
[[stage]]
name = "row"
tool = "flat6"
program = "heel.nc"
gate = { gouge = 1, uncut = 1 }
)");
}

}  // namespace

TEST_CASE("the error of a program's chords is none of the block's faces", "[e2e][setups]") {
  // Measured as the chords allow, not as deep as the block is.
  const Scratch scratch;
  write_heel(scratch);
  const Outcome outcome = run(scratch, "heel");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  const json row = finish_of(scratch);
  const double error_mm = row["toolpath"]["chord_error_mm"];
  REQUIRE(error_mm > 0);
  const json& gouge = row["deviation"]["gouge_mm"];
  CHECK(gouge["low"] <= kHeel_mm);
  CHECK(gouge["high"] >= kHeel_mm);
  CHECK(gouge["high"].get<double>() - gouge["low"].get<double>() < 0.1);  // the limit's tenth
}

// The blade, and its twin: docs/five-axis.md, whose commands and what they print are a test.

TEST_CASE("a blade whose program has the tool's axis in place of angles", "[e2e][setups]") {
  passes("blade", " --as vectors");
}

TEST_CASE("a bowl with an undercut that only a leaning tool reaches, and one axis wrong",
          "[e2e][setups]") {
  if (tests::thorough()) passes("bowl");
  fails_at_its_line("bowl", 50);
}

TEST_CASE("a deep cavity that a short tool reaches leaning, and with one B word wrong",
          "[e2e][setups]") {
  if (tests::thorough()) passes("cavity");
  fails_at_its_line("cavity", 50);
}

TEST_CASE("a head that turns as it cuts is held against X, Y and Z", "[e2e][turning]") {
  const Scratch scratch;
  post(scratch, "cavity", 2, "");
  // Where the axes go does not depend on part and stock.
  std::string job = read_text(scratch / "cavity.toml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    REQUIRE(job.find(from) != std::string::npos);
    job.replace(job.find(from), from.size(), to);
  };
  replace("[surface]\ncage = \"cavity.obj\"\n", "");
  replace("shape = \"mesh\"\nfile = \"cavity-stock.obj\"",
          "shape = \"box\"\nsize = [1, 1, 1]\ncorner = [0, 0, -300]");
  job.erase(job.find("[stage.gate]"), job.find("[simulation]") - job.find("[stage.gate]"));
  write_text(scratch / "cavity.toml", job);
  const auto exit_code = [&](const std::string& travel) {
    return limitgauge(scratch, {"run", "cavity.toml", "-o", "out", "--no-pictures", "--quiet",
                                "--force", "--set", "machine.travel.x=" + travel})
        .exit_code;
  };
  CHECK(exit_code("[-105, 1000]") == 0);
  REQUIRE(exit_code("[-102, 1000]") == 1);
  const json finding = finish_of(scratch)["simulation"]["findings"].at(0);
  CHECK(finding["kind"] == "beyond_travel");
  CHECK(finding["against"] == "x-");
  CHECK(finding["line"] == 9);
  // The tip stands at -10.35375; the axis that tilts by 20 degrees is 270 mm above it.
  CHECK(finding["depth_mm"].get<double>() ==
        Approx(10.35375 + 270 * std::sin(20 * M_PI / 180) - 102).margin(1e-6));
}

}  // namespace limitgauge::e2e
