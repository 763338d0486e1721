// Whose motions of a program are whose, where its stages lie in different setups or turn axes.

#include <fstream>

#include "app/inputs/setup_view.h"
#include "app/job/foreign_programs.h"
#include "app/job/job_reader.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

const std::string kSharedBegin =
    "G21 G90 G94\n(OP1)\nT1 M6\nS8000 M3\nG43 H1\nG0 Z20.\nG0 X-12. Y-10.\n";
const std::string kSharedCut = "G1 Z1. F600.\nG1 X12.\nG0 Z20.\n";
const std::string kSharedTurn = "G0 C180.\n", kSharedBack = "G0 C0.\n", kSharedEnd = "M5\nM30\n";

/// A stage that begins at a comment, or takes all of its program where there is none.
std::string shared_stage(const std::string& name, const std::string& program,
                         const std::string& comment, const std::string& keys = {}) {
  return "[[stage]]\nname = \"" + name + "\"\ntool = \"flat\"\nprogram = \"" + program + "\"\n" +
         (comment.empty() ? "" : "program_comment = \"" + comment + "\"\n") + keys +
         "[stage.gate]\ngouge = 0.01\nuncut = 0.1\n";
}

/// A job on a machine with a table that turns about Z, of which `tables` says the rest.
class SharedFolder {
 public:
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }
  Job job(const std::string& tables) const {
    const auto cage = tests::fixtures() / "cages/quick-dome.obj";
    write(
        "job.toml",
        "name = \"shared\"\n[surface]\ncage = \"" + cage.string() +
            "\"\n[stock]\nshape = \"box\"\nsize = [26, 26, 9]\ncorner = [-13, -13, -4]\n"
            "[machine]\nkinematics = \"table-table\"\ncontrol = \"fanuc\"\nwork_offsets = { G54 = "
            "[0, 0, 0] }\n[[machine.axis]]\nword = \"C\"\ndirection = [0, 0, 1]\npoint = [0, 0, "
            "0]\nlimits = [-720, 720]\n[[tool]]\nid = \"flat\"\ntype = \"flat\"\ndiameter = "
            "6\nflute_length = 20\nnumber = 1\nlength = 80\n" +
            tables);
    return read_job(folder_.path() / "job.toml");
  }
  std::string error(const std::string& tables) const {
    try {
      job(tables);
    } catch (const model::InputError& error) {
      return error.what();
    }
    return {};
  }

 private:
  tests::TemporaryFolder folder_;
};

TEST_CASE("a stretch that has the name of another stage is told with its line", "[unit][job]") {
  SharedFolder folder;
  folder.write("a.nc", kSharedBegin + kSharedCut + kSharedTurn + kSharedCut + kSharedBack +
                           kSharedCut + kSharedEnd);
  folder.write("b.nc", kSharedBegin + kSharedCut + kSharedEnd);
  const std::string error =
      folder.error(shared_stage("s", "a.nc", "") + shared_stage("s.2", "b.nc", ""));
  CHECK_THAT(error,
             ContainsSubstring("a.nc:11:") && ContainsSubstring("two stages are called \"s.2\""));
}

TEST_CASE("setups that turns make are called by names that no other has", "[unit][job]") {
  SharedFolder folder;
  folder.write("a.nc", kSharedBegin + kSharedCut + kSharedTurn + kSharedCut + kSharedBack +
                           kSharedCut + kSharedEnd);
  const std::string setup = "[[setup]]\nname = \"";
  const Job job = folder.job(setup + "v\"\n" + setup + "v.C180\"\n" +
                             shared_stage("s", "a.nc", "", "setup = \"v\"\n"));
  REQUIRE(job.setups.size() == 3);
  CHECK(job.setups.back().setup.name == "v.C180+");
}

}  // namespace

TEST_CASE("stages of two setups share out one program", "[unit][job]") {
  const SharedFolder folder;
  folder.write("p.nc",
               kSharedBegin + kSharedCut + "(OP2)\n" + kSharedCut + kSharedCut + kSharedEnd);
  const std::string setups =
      "[[setup]]\nname = \"v\"\n[[setup]]\nname = \"w\"\nrotate = [{ axis = [0, 0, 1], angle = 180 "
      "}]\n";
  const Job job = folder.job(setups + shared_stage("one", "p.nc", "OP1", "setup = \"v\"\n") +
                             shared_stage("two", "./p.nc", "OP2", "setup = \"w\"\n"));
  const auto first = read_stage_programs(in_setup(job, 0));
  const auto second = read_stage_programs(in_setup(job, 1));
  REQUIRE(first.size() == 1);
  REQUIRE(second.size() == 1);
  REQUIRE(first[0].ranges.size() == 1);
  REQUIRE(second[0].ranges.size() == 1);
  const std::size_t all = first[0].program.motions.size();
  CHECK(first[0].ranges[0].first == 0);
  CHECK(first[0].ranges[0].last == second[0].ranges[0].first);
  CHECK(second[0].ranges[0].last == all);
  // Two approaches and one cut of three moves before the second comment.
  CHECK(second[0].ranges[0].first == 5);
}

TEST_CASE("one stage of a program turns an axis, the other does not", "[unit][job]") {
  const SharedFolder folder;
  folder.write("p.nc", kSharedBegin + kSharedTurn + kSharedCut + kSharedBack + "(OP2)\n" +
                           kSharedCut + kSharedEnd);
  const Job job =
      folder.job(shared_stage("one", "p.nc", "OP1") + shared_stage("two", "p.nc", "OP2"));
  // One upright, turned and back, where nothing moves any more.
  REQUIRE(job.stages.size() == 4);
  CHECK(job.stages[1].name == "one");
  const JobStage& second = job.stages.back();
  CHECK(second.name == "two");
  REQUIRE(second.piece.has_value());
  CHECK(second.piece->range.first == job.stages[2].piece->range.last);
  CHECK(second.piece->range.last - second.piece->range.first == 3);
  CHECK(second.setup == job.stages[0].setup);
}

TEST_CASE("a program that ends with an axis turned is followed by none that says nothing of it",
          "[unit][job]") {
  const SharedFolder folder;
  folder.write("left.nc", kSharedBegin + kSharedTurn + kSharedCut + kSharedEnd);
  folder.write("whole.nc", kSharedBegin + kSharedTurn + kSharedCut + "G0 C360.\n" + kSharedEnd);
  folder.write("plain.nc", kSharedBegin + kSharedCut + kSharedEnd);
  folder.write("first.nc", "G21 G90 G94\nT1 M6\nS8000 M3\n" + kSharedTurn + "G43 H1\nG0 Z20.\n" +
                               kSharedCut + kSharedEnd);
  const auto after = [&](const std::string& one, const std::string& two) {
    return folder.error(shared_stage("one", one, "") + shared_stage("two", two, ""));
  };
  CHECK_THAT(after("left.nc", "plain.nc"),
             Catch::Contains("left.nc: error: the program of stage \"one\" ends with C turned, and "
                             "stage \"two\" begins as if it stood at 0"));
  CHECK_THAT(after("left.nc", "left.nc"), Catch::Contains("begins as if it stood at 0"));
  CHECK(after("left.nc", "first.nc").empty());
  const auto begun = [&](const std::string& name, const std::string& turn) {
    folder.write(name, "G21 G90 G94\nT1 M6\nS8000 M3\n" + turn + "G43 H1\nG0 Z20.\n" + kSharedCut +
                           kSharedEnd);
    return after("left.nc", name);
  };
  CHECK(begun("other.nc", "G0 C90.\n").empty());
  CHECK_THAT(begun("by.nc", "G91 G0 C90.\nG90\n"), Catch::Contains("begins as if it stood at 0"));
  CHECK_THAT(begun("home.nc", "G0 C0.\n"), Catch::Contains("begins as if it stood at 0"));
  CHECK_THAT(begun("late.nc", "G0 X1.\nG0 C90.\n"), Catch::Contains("begins as if it stood at 0"));
  // What turns is checked on its way from where it was left.
  const Job job =
      folder.job(shared_stage("one", "left.nc", "") + shared_stage("two", "other.nc", ""));
  const auto& turns = job.stages.back().piece->range.turns;
  REQUIRE(turns.size() == 1);
  CHECK(turns[0].turn.from_deg == model::RotaryAngles{0, 0, 180});
  CHECK(turns[0].turn.to_deg == model::RotaryAngles{0, 0, 90});
  // Whole turns too: a C0 or a C90 that comes next unwinds them.
  CHECK_THAT(after("whole.nc", "plain.nc"), Catch::Contains("begins as if it stood at 0"));
  CHECK_THAT(after("whole.nc", "late.nc"), Catch::Contains("begins as if it stood at 0"));
  CHECK(after("whole.nc", "other.nc").empty());
  const Job unwound =
      folder.job(shared_stage("one", "whole.nc", "") + shared_stage("two", "other.nc", ""));
  CHECK(unwound.stages.back().piece->range.turns.at(0).turn.from_deg[2] == 360);
  CHECK(after("plain.nc", "left.nc").empty());
}

TEST_CASE("each axis that was left turned is named by the program that comes next", "[unit][job]") {
  const SharedFolder folder;
  folder.write("left.nc", kSharedBegin + "G0 A30.\n" + kSharedCut + kSharedEnd);
  const std::string second =
      "[[machine.axis]]\nword = \"A\"\ndirection = [1, 0, 0]\npoint = [0, 0, -50]\nlimits = [-120, "
      "120]\n";
  const auto begun = [&](const std::string& turn) {
    folder.write("next.nc", "G21 G90 G94\nT1 M6\nS8000 M3\n" + turn + "G43 H1\nG0 Z20.\n" +
                                kSharedCut + kSharedEnd);
    return folder.error(second + shared_stage("one", "left.nc", "") +
                        shared_stage("two", "next.nc", ""));
  };
  // The other axis says nothing of it.
  CHECK_THAT(begun("G0 C90.\n"), Catch::Contains("ends with A turned"));
  CHECK_THAT(begun("G0 C90.\nG91 G0 A10.\nG90\n"), Catch::Contains("ends with A turned"));
  CHECK(begun("G0 C90.\nG0 A10.\n").empty());
  CHECK(begun("G0 A10. C90.\n").empty());
}

TEST_CASE("a program that never cuts answers for every way in which its tool stood",
          "[unit][job]") {
  const SharedFolder folder;
  const std::string rapids = "G0 Z10.\nG0 X12.\nG0 Z20.\n";
  folder.write("forgotten.nc",
               kSharedBegin + kSharedTurn + rapids + kSharedBack + rapids + kSharedEnd);
  folder.write("cuts.nc",
               kSharedBegin + kSharedTurn + kSharedCut + kSharedBack + rapids + kSharedEnd);
  const Job never = folder.job(shared_stage("one", "forgotten.nc", ""));
  REQUIRE(never.stages.size() == 3);
  for (const JobStage& piece : never.stages) CHECK_FALSE(only_positions(piece));
  const Job once = folder.job(shared_stage("one", "cuts.nc", ""));
  REQUIRE(once.stages.size() == 3);
  CHECK(only_positions(once.stages[0]));
  CHECK_FALSE(only_positions(once.stages[1]));
  CHECK(only_positions(once.stages[2]));
}

}  // namespace limitgauge::app
