#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/cli/usage_error.h"
#include "app/job/settings.h"
#include "app/verify/verify_job.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

/// The plate's program without its design.
std::string cut_job(const std::string& stage = {}) {
  return R"(name = "plate"
[stock]
shape = "box"
size = [60, 40, 12]
corner = [-30, -20, -12]
[[tool]]
id = "flat8"
type = "flat"
diameter = 8
[[stage]]
name = "all"
tool = "flat8"
program = "foreign/plate.ngc"
)" + stage;
}

TEST_CASE("a job without a surface reads programs and has no design", "[unit][job][cut]") {
  const Job job = read(cut_job());
  CHECK_FALSE(job.design);
  REQUIRE(job.stages.size() == 1);
  CHECK_FALSE(job.stages[0].limits.has_gouge);
  for (const std::string& said : job.defaulted) {
    CHECK_THAT(said, !ContainsSubstring("allowance") && !ContainsSubstring("surface precision"));
  }
}

TEST_CASE("what needs a design is refused by its key, with what would do", "[unit][job][cut]") {
  std::string planned = cut_job();
  planned = with(planned, "program = \"foreign/plate.ngc\"",
                 "strategy = \"contour\"\nstep = 1\ntolerance = 0.1\nfeed = 500");
  CHECK(
      error_of(planned) ==
      "job.toml:13:12: error: stage \"all\" is to be planned, and the job has no [surface] to plan "
      "it for; expected a [surface] with the design, or \"program\" instead of \"strategy\"");
  CHECK_THAT(error_of(cut_job("allowance = 0.1\n")),
             ContainsSubstring("job.toml:14:13: error: \"allowance\"") &&
                 ContainsSubstring("no [surface]"));
  for (const std::string key :
       {"gouge = 0.1", "uncut = 0.1", "coverage = 0.9", "unreachable = 0.1", "unavoidable = 0.1"})
    CHECK_THAT(error_of(cut_job("[stage.gate]\n" + key + "\n")),
               ContainsSubstring("job.toml:15:") &&
                   ContainsSubstring("limits what is measured against a surface") &&
                   ContainsSubstring("only in a job with [surface]"));
  CHECK_THAT(error_of(cut_job("[verification]\nresolution = 0.1\n")),
             ContainsSubstring("[verification] is of what is measured against a surface"));
  CHECK_THAT(
      error_of(cut_job(), {"stage.all.gate.uncut=1"}),
      ContainsSubstring("--set stage.all.gate.uncut=1") && ContainsSubstring("no [surface]"));
}

TEST_CASE("the voxel without a design goes by the smallest cutter and the stock",
          "[unit][settings][cut]") {
  Job job = read(cut_job());
  CHECK(automatic_voxel_mm(job) == Approx(0.2));
  job.stages[0].cutter.diameter_mm = 1;
  CHECK(automatic_voxel_mm(job) == Approx(0.05));
  job.stages[0].cutter.diameter_mm = 80;
  CHECK(automatic_voxel_mm(job) == Approx(0.5));
  job.stages.push_back(job.stages[0]);
  job.stages[1].cutter.diameter_mm = 6;
  CHECK(automatic_voxel_mm(job) == Approx(0.15));
  job.stock = model::BoxStock{{0, 0, 0}, {1000, 600, 80}};
  CHECK(automatic_voxel_mm(job) == Approx(0.54));
}

TEST_CASE("what was chosen without a design is said", "[unit][settings][cut]") {
  const Job job = read(cut_job());
  const Settings settings = choose_settings(job, {}, kMemory);
  CHECK(settings.resolution_mm.empty());
  CHECK(settings.chord_error_mm == std::vector<double>{0.0005});
  std::string all;
  for (const std::string& line : assumptions(job, settings)) all += line + "\n";
  for (const char* said : {"no design: nothing is measured",
                           "voxel 0.2 mm (auto: a fortieth of the "
                           "smallest cutter's diameter",
                           "arcs as chords within 5e-04 mm"})
    CHECK_THAT(all, ContainsSubstring(said));
  CHECK_THAT(all, !ContainsSubstring("cage") && !ContainsSubstring("resolution"));
}

CutCommand plate_cut() {
  CutCommand command;
  command.program = tests::fixtures() / "foreign/plate.ngc";
  command.stock = "box:60,40,12@-30,-20,-12";
  command.tools = {"flat:D=8"};
  return command;
}

TEST_CASE("cut takes a job's keys but those of a design", "[unit][cli][cut]") {
  CutCommand command = plate_cut();
  command.voxel_mm = 0.3;
  Job job = job_of(command);
  CHECK_FALSE(job.design);
  CHECK(job.voxel_mm == 0.3);
  apply_verify_overrides(job, std::vector<std::string>{"simulation.near_miss=1", "name=other"});
  CHECK(job.near_miss_mm == 1);
  CHECK(job.name == "other");
  CHECK(job.voxel_mm == 0.3);
  const auto refused = [&](const std::string& override) {
    return tests::message_of<model::InputError>(
        [&] { apply_verify_overrides(job, std::vector<std::string>{override}); });
  };
  CHECK_THAT(refused("surface.precision=0.1"),
             ContainsSubstring("cut measures against no surface; expected limitgauge verify"));
  CHECK_THAT(refused("stage.program.gate.gouge=1"), ContainsSubstring("no [surface]"));
  CHECK_THAT(refused("stage.program.allowance=1"), ContainsSubstring("no [surface]"));
  CHECK_THAT(refused("verification.resolution=1"), ContainsSubstring("no [surface]"));
  CHECK_THAT(refused("tool=1"), ContainsSubstring("cut takes \"tool\""));
}

TEST_CASE("a tool that the program loads nowhere is said", "[unit][cli][cut]") {
  CutCommand command = plate_cut();
  command.tools = {"1=flat:D=8,L=80", "2=flat:D=6,L=60"};
  const auto idle = [](const Job& job) {
    return std::count_if(job.defaulted.begin(), job.defaulted.end(), [](const std::string& said) {
      return said == "T7, which --tool states, is loaded nowhere: nothing is cut with it";
    });
  };
  CHECK(idle(job_of(command)) == 0);
  command.tools.push_back("7=ball:D=6,L=20");
  CHECK(idle(job_of(command)) == 1);
  CHECK(job_of(command).stages.size() == 2);
}

TEST_CASE("a tool table that has another diameter is told", "[unit][cli][cut]") {
  const std::filesystem::path table = std::filesystem::temp_directory_path() / "limitgauge_d.tbl";
  CutCommand command = plate_cut();
  command.tools = {"1=flat:D=8,L=80", "2=flat:D=6,L=60"};
  command.machine.tool_table = table;
  const auto told = [&](const char* text) {
    std::ofstream(table) << text;
    const Job job = job_of(command);
    std::vector<std::string> out;
    for (const std::string& said : job.defaulted)
      if (said.find("the tool table has") == 0) out.push_back(said);
    return out;
  };
  CHECK(told("T1 P1 D8 Z50\nT2 P2 Z40\n").empty());
  CHECK(told("T1 P1 D7.98 Z50\nT2 P2 Z40\n") ==
        std::vector<std::string>{"the tool table has T1 7.98 mm wide, which cutter compensation "
                                 "takes; what cuts is 8 mm wide"});
  std::filesystem::remove(table);
}

TEST_CASE("verify says what --cage takes where it gets something else", "[unit][cli][cut]") {
  VerifyCommand command;
  static_cast<CutCommand&>(command) = plate_cut();
  for (const char* file : {"part.stl", "part.STL", "part.ply", "part.step", "part.stp"}) {
    command.cage = file;
    const std::string said = tests::message_of<UsageError>([&] { job_of(command); });
    CHECK_THAT(said, ContainsSubstring(std::string("--cage ") + file) &&
                         ContainsSubstring("control cage") && ContainsSubstring("limitgauge cut"));
  }
}

}  // namespace
}  // namespace limitgauge::app
