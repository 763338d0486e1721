#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/e2e/memory/forecast.h"
#include "tests/e2e/program.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace limitgauge::e2e {
namespace {

using nlohmann::json;

/// Slots through a block whose top is at zero; nothing is wrong with it.
const std::string kClean = R"(G21 G17 G90
M3 S8000
G0 Z10
G0 X-6 Y10
G1 Z-2 F600
G1 X56
G2 X56 Y30 I0 J10
G1 X-6
G0 Z10
M5
M30
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::vector<std::string> cut(const std::string& program, const std::string& output,
                             const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"cut",
                                    "--stock",
                                    "box:50,40,20@0,0,-20",
                                    "--tool",
                                    "flat:D=6,L=8,shank=6:2,holder=30:20",
                                    "--program",
                                    program,
                                    "--voxel",
                                    "0.25",
                                    "--no-pictures",
                                    "-o",
                                    output};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

json result_of(const Scratch& scratch, const std::string& output) {
  return json::parse(read_text(scratch / (output + "/result.json")));
}

/// Cuts `program` and gives its findings.
json findings_of(const Scratch& scratch, const std::string& program, int expected) {
  write_text(scratch / "p.ngc", program);
  const Outcome outcome = limitgauge(scratch, cut("p.ngc", "out", {"--force"}));
  INFO(outcome.out << outcome.errors);
  CHECK(outcome.exit_code == expected);
  return result_of(scratch, "out")["stages"][0]["simulation"]["findings"];
}

TEST_CASE("a clean program passes, and nothing is said of a surface", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "p.ngc", kClean);
  const Outcome outcome = limitgauge(scratch, cut("p.ngc", "out", {"--verbose"}));
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  check_forecast(outcome);
  CHECK_THAT(outcome.out, ContainsSubstring("nothing was measured against a design"));
  const json result = result_of(scratch, "out");
  CHECK_FALSE(result.contains("surface"));
  const json stage = result["stages"][0];
  CHECK_FALSE(stage.contains("deviation"));
  CHECK(stage["simulation"]["findings"].empty());
  CHECK(stage["simulation"]["removed_volume_mm3"].get<double>() > 500);
  CHECK(stage["toolpath"]["machining_time_s"].get<double>() > 10);
  const std::string page = read_text(scratch / "out/report.html");
  CHECK_THAT(page, ContainsSubstring("Nothing was measured against a design."));
  CHECK_THAT(page, !ContainsSubstring("Error map in 3D"));
  for (const char* file : {"stock.vdb", "stock.vtp", "toolpath.vtp", "toolpath.ngc"})
    CHECK(std::filesystem::exists(scratch / "out/program" / file));
  CHECK_FALSE(std::filesystem::exists(scratch / "out/program/deviation.vtp"));
}

TEST_CASE("what is planted in the process is found at its line", "[e2e][cut]") {
  const Scratch scratch;
  struct Planted {
    std::string program, kind;
    int line;
  };
  for (const Planted& planted :
       {Planted{replaced(kClean, "G1 Z-2 F600\nG1 X56\n", "G1 Z-2 F600\nG0 X56\n"),
                "rapid_through_stock", 6},
        Planted{replaced(kClean, "G1 Z-2 F600\nG1 X56\n", "G1 Z-2 F600\nM5\nG1 X56\n"),
                "spindle_stopped", 7},
        Planted{replaced(kClean, "G1 Z-2 F600", "G1 Z-15 F600"), "holder_in_stock", 5}}) {
    INFO(planted.kind);
    const json findings = findings_of(scratch, planted.program, 1);
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const json& finding) {
      return finding["kind"] == planted.kind;
    });
    INFO(findings);
    REQUIRE(found != findings.end());
    CHECK((*found)["first_line"] == planted.line);
    CHECK_THAT(read_text(scratch / "out/findings.sarif"), ContainsSubstring(planted.kind));
    CHECK_THAT(read_text(scratch / "out/junit.xml"), ContainsSubstring("<failure"));
  }
}

TEST_CASE("a fixture in the way is found", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "p.ngc", kClean);
  write_text(scratch / "clamp.obj",
             "v 20 5 0\nv 30 5 0\nv 30 15 0\nv 20 15 0\nv 20 5 5\nv 30 5 5\nv 30 15 5\nv 20 15 5\n"
             "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Outcome outcome = limitgauge(scratch, cut("p.ngc", "out", {"--fixture", "clamp.obj"}));
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 1);
  const json finding = result_of(scratch, "out")["stages"][0]["simulation"]["findings"][0];
  CHECK(finding["kind"] == "fixture_touched");
  CHECK(finding["first_line"] == 6);
  CHECK(finding["against"] == "clamp.obj");
}

TEST_CASE("the same program gives the same files for one and two threads", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "p.ngc", kClean);
  for (const std::string threads : {"1", "2"})
    REQUIRE(limitgauge(scratch, cut("p.ngc", "t" + threads, {"--threads", threads})).exit_code ==
            0);
  for (const char* file : {"findings.csv", "findings.sarif", "program/stock.vtp",
                           "program/stock.vdb", "program/toolpath.vtp"})
    CHECK(read_text(scratch / ("t1/" + std::string(file))) ==
          read_text(scratch / ("t2/" + std::string(file))));
  const auto blob = [&](const std::string& folder) {
    const std::string page = read_text(scratch / (folder + "/report.html"));
    const std::size_t from = page.find("id=\"limitgauge-blob\"");
    REQUIRE(from != std::string::npos);
    return page.substr(from, page.find("</script>", from) - from);
  };
  CHECK(blob("t1") == blob("t2"));
}

TEST_CASE("stock and program moved alike are cut alike", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "p.ngc", replaced(kClean, "G1 Z-2 F600\nG1 X56\n", "G1 Z-2 F600\nG0 X56\n"));
  limitgauge(scratch, cut("p.ngc", "here"));
  std::vector<std::string> there = cut("p.ngc", "there", {"--program-offset", "128,-64,32"});
  there[2] = "box:50,40,20@128,-64,12";
  limitgauge(scratch, there);
  const json a = result_of(scratch, "here")["stages"][0],
             b = result_of(scratch, "there")["stages"][0];
  CHECK(a["verdict"] == "fail");
  CHECK(b["verdict"] == "fail");
  const auto volume = [](const json& stage) {
    return stage["simulation"]["removed_volume_mm3"].get<double>();
  };
  CHECK(volume(a) == Approx(volume(b)).epsilon(1e-6));
  REQUIRE(a["simulation"]["findings"].size() == b["simulation"]["findings"].size());
  for (std::size_t i = 0; i < a["simulation"]["findings"].size(); ++i)
    for (const char* key : {"kind", "first_line", "last_line", "count"})
      CHECK(a["simulation"]["findings"][i][key] == b["simulation"]["findings"][i][key]);
}

TEST_CASE("several tools are stages of their own", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "two.ngc",
             "T1 M6\nM3 S1000\nG0 X25 Y20 Z20\nG1 Z-5 F100\nX30\nG0 Z20\nT2 M6\nM3 S5000\n"
             "G0 X10 Y10\nG1 Z-3 F200\nX40\nG0 Z20\nM2\n");
  const Outcome outcome = limitgauge(
      scratch, {"cut", "--stock", "box:50,40,20@0,0,-20", "--tool", "1=flat:D=6", "--tool",
                "2=ball:D=4", "--program", "two.ngc", "-o", "out", "--no-pictures", "--history",
                "h.sqlite", "--set", "simulation.voxel=0.3"});
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json result = result_of(scratch, "out");
  REQUIRE(result["stages"].size() == 2);
  CHECK(result["stages"][0]["name"] == "T1");
  CHECK(result["stages"][1]["simulation"]["voxel_mm"] == 0.3);
  CHECK(limitgauge(scratch, {"compare", "out", "out"}).exit_code == 0);
  CHECK(limitgauge(scratch, {"history", "h.sqlite", "-o", "history"}).exit_code == 0);
}

TEST_CASE("a program that comes to no stock says so", "[e2e][cut]") {
  const Scratch scratch;
  for (const char* program :
       {"G0 X0 Y0 Z50\nG0 X50\nM2\n", "M3 S1000\nG0 X200 Y200 Z20\nG1 Z-5 F100\nG0 Z20\nM2\n"}) {
    write_text(scratch / "p.ngc", program);
    const Outcome outcome = limitgauge(scratch, cut("p.ngc", "out", {"--force"}));
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, ContainsSubstring("nothing was cut"));
    CHECK_THAT(read_text(scratch / "out/report.html"), ContainsSubstring("nothing was cut"));
  }
}

TEST_CASE("bad input to cut writes nothing", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "empty.ngc", "");
  write_text(scratch / "p.ngc", kClean);
  for (const auto& words :
       {cut("nowhere.ngc", "out"), cut("empty.ngc", "out"), cut("p.ngc", "out", {"--voxel", "0"}),
        cut("p.ngc", "out", {"--voxel", "100"}), cut("p.ngc", "out", {"--gouge", "0.1"}),
        cut("p.ngc", "out", {"--set", "stage.program.gate.gouge=0.1"}),
        cut("p.ngc", "out", {"--set", "surface.cage=a.obj"})}) {
    const Outcome outcome = limitgauge(scratch, words);
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 3);
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
  }
}

/// The same as a job, and what else reads jobs.
TEST_CASE("a job without a surface is cut as cut does, and no study is made of it", "[e2e][cut]") {
  const Scratch scratch;
  write_text(scratch / "p.ngc", kClean);
  write_text(scratch / "job.toml", R"(name = "p"
[stock]
shape = "box"
size = [50, 40, 20]
corner = [0, 0, -20]
[[tool]]
id = "flat6"
type = "flat"
diameter = 6
flute_length = 8
shank = { diameter = 6, length = 2 }
holder = [{ diameter = 30, length = 20 }]
[[stage]]
name = "program"
tool = "flat6"
program = "p.ngc"
[simulation]
voxel = 0.25
)");
  REQUIRE(limitgauge(scratch, cut("p.ngc", "cut")).exit_code == 0);
  const Outcome run = limitgauge(scratch, {"run", "job.toml", "-o", "run", "--no-pictures"});
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const json a = result_of(scratch, "cut")["stages"][0], b = result_of(scratch, "run")["stages"][0];
  CHECK(a["simulation"]["removed_volume_mm3"] == b["simulation"]["removed_volume_mm3"]);
  CHECK(a["toolpath"]["machining_time_s"] == b["toolpath"]["machining_time_s"]);
  CHECK(limitgauge(scratch, {"plan", "job.toml", "-o", "plan"}).exit_code == 0);
  write_text(
      scratch / "study.toml",
      "name = \"s\"\njob = \"job.toml\"\n[[vary]]\nkey = \"simulation.voxel\"\nvalues = [0.2, "
      "0.3]\n");
  const Outcome study = limitgauge(scratch, {"study", "study.toml", "-o", "study"});
  CHECK(study.exit_code == 3);
  CHECK_THAT(study.errors, ContainsSubstring("the job has no [surface]"));
  const Outcome slurm = limitgauge(scratch, {"run", "job.toml", "-o", "x", "--engine", "slurm"});
  CHECK(slurm.exit_code == 3);
  CHECK_THAT(slurm.errors, ContainsSubstring("--engine slurm shares out"));
}

TEST_CASE("a cut and a verified result are not compared", "[e2e][cut]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, run_coarse_job("run")).exit_code == 0);
  write_text(scratch / "p.ngc", kClean);
  REQUIRE(limitgauge(scratch, cut("p.ngc", "cut")).exit_code == 0);
  const Outcome outcome = limitgauge(scratch, {"compare", "run", "cut"});
  CHECK(outcome.exit_code == 3);
  CHECK_THAT(outcome.errors, ContainsSubstring("a program cut without a design"));
}

/// Rows of a ball over a wavy top, a million moves when there is time.
TEST_CASE("a long program is cut within what was forecast", "[slow][cut][memory]") {
  const Scratch scratch;
  std::string program = "G21 G90\nM3 S12000\nG0 Z10\nG0 X0 Y0\nG1 Z-1 F2000\n";
  const int rows = tests::by_effort(100, 500);
  char line[64];
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < 2000; ++k) {
      const double t = k / 1999.0, x = 100 * (row % 2 == 0 ? t : 1 - t),
                   y = 100.0 * row / (rows - 1);
      std::snprintf(line, sizeof line, "G1 X%.4f Y%.4f Z%.4f\n", x, y,
                    -6 + 4 * std::sin(x / 11) * std::cos(y / 9));
      program += line;
    }
  write_text(scratch / "p.ngc", program + "G0 Z10\nM30\n");
  const Outcome outcome =
      limitgauge(scratch, {"cut", "--stock", "box:100,100,50@0,0,-50", "--tool", "ball:D=6,L=25",
                           "--program", "p.ngc", "--voxel", "0.1", "-o", "out", "--verbose"});
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  check_forecast(outcome);
  CHECK(outcome.peak_bytes < 1.5e9);
}

}  // namespace
}  // namespace limitgauge::e2e
