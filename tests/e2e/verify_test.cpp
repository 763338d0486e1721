#include <nlohmann/json.hpp>
#include <regex>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// The rough program of the quick job.
std::string rough_program(const Scratch& scratch) {
  REQUIRE(limitgauge(scratch, {"plan", fixture("jobs/quick-dome.toml"), "-o", "plan"}).exit_code ==
          0);
  return read_text(scratch / "plan/rough/toolpath.ngc");
}

std::vector<std::string> verify_rough(const std::string& program, const std::string& output) {
  return {"verify",
          "--cage",
          fixture("cages/quick-dome.obj"),
          "--stock",
          "box:26,26,9@-13,-13,-4",
          "--tool",
          "flat:D=6,L=20,shank=6:30",
          "--program",
          program,
          "--allowance",
          "0.3",
          "-o",
          output,
          "--no-pictures"};
}

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

json stage_of(const fs::path& folder) {
  return json::parse(read_text(folder / "result.json"))["stages"][0];
}

/// Every cutting height of `program` lowered: Z below the stock's top at 5 mm.
std::string sunk(const std::string& program, double by_mm) {
  static const std::regex z_word("Z(-?[0-9.]+)");
  std::string result;
  auto from = program.cbegin();
  for (std::sregex_iterator it(program.begin(), program.end(), z_word), end; it != end; ++it) {
    result.append(from, (*it)[0].first);
    const double z = std::stod((*it)[1]);
    result += "Z" + std::to_string(z < 5 ? z - by_mm : z);
    from = (*it)[0].second;
  }
  return result.append(from, program.cend());
}

TEST_CASE("verify judges a program without a job as run does", "[e2e][verify]") {
  const Scratch scratch;
  rough_program(scratch);
  const Outcome outcome = limitgauge(scratch, with(verify_rough("plan/rough/toolpath.ngc", "out"),
                                                   {"--gouge", "0.1", "--uncut", "1"}));
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json stage = stage_of(scratch / "out");
  CHECK(stage["name"] == "program");
  CHECK(stage["program"] == "plan/rough/toolpath.ngc");
  CHECK(stage["verdict"] == "pass");
  CHECK(read_text(scratch / "out/program/toolpath.ngc") ==
        read_text(scratch / "plan/rough/toolpath.ngc"));
  REQUIRE(
      limitgauge(scratch, {"run", fixture("jobs/quick-dome.toml"), "-o", "run", "--no-pictures"})
          .exit_code == 0);
  const json of_run = stage_of(scratch / "run");
  // The same moves, and from where the program is assumed to start two rapids to where the planned
  // path begins, one up or down and one across; the same gate limits: the same removed material
  // within the two grids.
  CHECK(stage["toolpath"]["moves"] == of_run["toolpath"]["moves"].get<int>() + 2);
  CHECK(stage["simulation"]["removed_volume_mm3"].get<double>() ==
        Approx(of_run["simulation"]["removed_volume_mm3"].get<double>()).epsilon(0.01));
}

TEST_CASE("without limits a program is measured and not gated", "[e2e][verify]") {
  const Scratch scratch;
  write_text(scratch / "sunk.ngc", sunk(rough_program(scratch), 0.25));
  const Outcome outcome = limitgauge(scratch, verify_rough("sunk.ngc", "out"));
  CHECK(outcome.exit_code == 0);
  CHECK(stage_of(scratch / "out")["deviation"]["gouge_mm"]["low"] > 0.1);
}

TEST_CASE("verify takes keys of the job and gates of what cannot be reached", "[e2e][verify]") {
  const Scratch scratch;
  rough_program(scratch);
  const std::vector<std::string> words = verify_rough("plan/rough/toolpath.ngc", "out");
  const Outcome outcome = limitgauge(
      scratch,
      with(words, {"--coverage", "0.5", "--unreachable", "1", "--unavoidable", "5", "--set",
                   "simulation.voxel=0.4", "--set", "stage.program.gate.gouge=0.1"}));
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  const json stage = stage_of(scratch / "out");
  CHECK(stage["simulation"]["voxel_mm"] == 0.4);
  CHECK(stage["gate"] ==
        json{{"coverage", 0.5}, {"gouge_mm", 0.1}, {"unavoidable_mm", 5.0}, {"unreachable", 1.0}});
  const Outcome wrong = limitgauge(scratch, with(words, {"--set", "simulation.vox=1", "--force"}));
  CHECK(wrong.exit_code == 3);
  CHECK_THAT(wrong.errors, ContainsSubstring("--set simulation.vox=1: error: unknown key"));
  const Outcome unit = limitgauge(scratch, with(words, {"--unreachable", "3 cm2", "--force"}));
  CHECK(unit.exit_code == 3);
  CHECK_THAT(unit.errors, ContainsSubstring("--unreachable"));
}

TEST_CASE("a sunk program fails, and the finding names a line of it", "[e2e][verify]") {
  const Scratch scratch;
  const std::string program = sunk(rough_program(scratch), 0.25);
  write_text(scratch / "sunk.ngc", program);
  const Outcome outcome =
      limitgauge(scratch, with(verify_rough("sunk.ngc", "out"), {"--gouge", "0.1"}));
  CHECK(outcome.exit_code == 1);
  const json stage = stage_of(scratch / "out");
  CHECK(stage["verdict"] == "fail");
  REQUIRE_FALSE(stage["deviation"]["gouges"].empty());
  const auto line = stage["deviation"]["gouges"][0]["line"].get<long>();
  CHECK(line >= 1);
  CHECK(line <= std::count(program.begin(), program.end(), '\n'));
  // Sunk by 0.25 mm along z; along the normal that is 0.25 cos of the slope, and the flat cutter's
  // stairs may have left something of it.
  CHECK(stage["deviation"]["gouge_mm"]["high"] <= 0.25 + 0.1);
  CHECK(stage["deviation"]["gouge_mm"]["low"] >= 0.1);
}

TEST_CASE("a stage of a job may name a program", "[e2e][verify]") {
  const Scratch scratch;
  write_text(scratch / "rough.ngc", rough_program(scratch));
  std::string job = read_text(fixture("jobs/quick-dome.toml"));
  job.replace(job.find("../cages"), 8, fixture("cages"));
  const std::size_t from = job.find("strategy = \"contour\"");
  const std::size_t to = job.find("floor = -0.5\n") + 13;
  job.replace(from, to - from, "program = \"rough.ngc\"\nallowance = 0.3\n");
  write_text(scratch / "job.toml", job);
  REQUIRE(limitgauge(scratch, {"run", "job.toml", "-o", "out", "--no-pictures"}).exit_code == 0);
  CHECK(stage_of(scratch / "out")["program"] == "rough.ngc");
}

}  // namespace
}  // namespace limitgauge::e2e
