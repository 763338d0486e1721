#include "app/job/foreign_programs.h"

#include <fstream>

#include "app/inputs/run_inputs.h"
#include "model/base/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

/// The dome job with programs in place of its strategy; block top at z = 5, part below it.
class Bench {
 public:
  explicit Bench(const std::vector<std::string>& programs, const std::string& keys = {}) {
    std::string text = good_job();
    text.resize(text.find("[[stage]]"));
    if (!keys.empty()) text = with(text, "[[tool]]", keys + "\n[[tool]]");
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const std::string file = (folder_.path() / ("p" + std::to_string(i) + ".ngc")).string();
      std::ofstream(file) << programs[i];
      text += "[[stage]]\nname = \"s" + std::to_string(i) + "\"\ntool = \"ball3\"\nprogram = \"" +
              file + "\"\n";
    }
    job_ = read(text);
  }
  const Job& job() const { return job_; }
  std::vector<std::optional<ForeignPath>> load() const {
    const model::Box3 part{{-10, -10, -3}, {10, 10, 4}};
    return load_programs(job_, choose_settings(job_, part, kMemory), {}, part);
  }
  std::string error() const {
    try {
      load();
    } catch (const model::InputError& error) {
      return error.what();
    }
    return "no error";
  }

 private:
  tests::TemporaryFolder folder_;
  Job job_;
};

bool says(const ForeignPath& path, const std::string& part) {
  for (const std::string& said : path.assumed)
    if (said.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a slot cut before Y is named is cut where the program starts", "[unit][program]") {
  const Bench bench({"G0 X-20\nG0 Z9\nG1 Z-3 F500\nG1 X20\nG0 Z9\n"});
  const ForeignPath path = *bench.load().front();
  // Clearance 5 above the highest of stock (5), part (4) and programmed heights (9).
  CHECK(path.start.assumed);
  CHECK(path.start.at_mm == model::Vec3{0, 0, 14});
  CHECK(path.path->start == model::Vec3{0, 0, 14});
  REQUIRE(path.path->moves.size() == 5);
  CHECK(path.path->moves[3].to == model::Vec3{20, 0, -3});
  CHECK(path.path->moves[3].kind == model::MoveKind::feed);
  CHECK(says(path, "line 3: cuts before X, Y and Z have all been named"));
}

TEST_CASE("offsets that a program leaves are told with the programs after it", "[unit][program]") {
  const std::string cut = "G21 G90\nG0 X0 Y0 Z20\nG1 X5 F500\n";
  const std::string left = "begins with the job's work and tool offsets, not with those that";
  const Bench bench(
      {cut + "M2\n", cut + "G92 Z15\nM2\n", cut + "M2\n", cut + "G92 Z1\nG92.1\nM2\n"});
  auto paths = bench.load();
  tell_offsets_left(paths);
  CHECK(!says(*paths[0], left));
  CHECK(!says(*paths[1], left));
  CHECK(says(*paths[2], "p1.ngc ends with (line 4)"));
  CHECK(says(*paths[3], left));
  CHECK(paths[2]->path->moves.back().to.z == 20);
}

TEST_CASE("the start of programs is the job's, in their own frame", "[unit][program]") {
  const std::string program = "G21 G91\nG1 X5 F500\n";
  const Bench stated({program},
                     "[machine]\nstart = [1, 2, 30]\nwork_offsets = { G54 = [100, 50, 7] }\n"
                     "[program_frame]\noffset = [-4, 0, 1]\nrotate_z = 90");
  const ForeignPath path = *stated.load().front();
  CHECK(!path.start.assumed);
  CHECK(path.assumed.empty());
  CHECK(path.path->start == model::Vec3{-6, 1, 31});
  CHECK(path.path->moves.back().to == model::Vec3{-6, 6, 31});
  // Assumed: the zero of the programs, wherever it lies over the part.
  const Bench open({program}, "[program_frame]\noffset = [-4, 0, 1]");
  CHECK(open.load().front()->start.at_mm == model::Vec3{0, 0, 9});
  CHECK(open.load().front()->path->start == model::Vec3{-4, 0, 10});
}

TEST_CASE("all programs of a job start at one place", "[unit][program]") {
  const Bench bench({"G0 X1 Y1 Z6\nG1 X2 F9\n", "G0 X1\nG1 Z40 F9\nX2\n"});
  const auto paths = bench.load();
  for (const auto& path : paths) CHECK(path->start.at_mm == model::Vec3{0, 0, 45});
  CHECK(paths[0]->path->start == model::Vec3{0, 0, 45});
  CHECK(!says(*paths[0], "cuts before"));
  CHECK(paths[1]->path->moves.back().to == model::Vec3{2, 0, 40});
}

TEST_CASE("a program without an end is told", "[unit][program]") {
  const std::string moves = "G21 G90\nG0 X0 Y0 Z9\nG1 X5 F500\n";
  CHECK(Bench({moves + "M30\n"}).load().front()->unended.empty());
  CHECK_THAT(Bench({moves}).load().front()->unended,
             ContainsSubstring("p0.ngc ends without M2, M30 or '%': taken to be whole"));
}

TEST_CASE("what G92 says of the start goes before what is assumed", "[unit][program]") {
  const Bench bench({"G92 X3 Y4 Z12\nG1 X5 F9\n"});
  const ForeignPath path = *bench.load().front();
  CHECK(path.path->start == model::Vec3{3, 4, 12});
  CHECK(path.path->moves.back().to == model::Vec3{5, 4, 12});
  // A motion before it too.
  const Bench later({"G0 Z8\nG92 X3 Y4\nG1 X5 F9\n"});
  CHECK(later.load().front()->path->start == model::Vec3{3, 4, 13});
}

TEST_CASE("the first GOTO of CL data is a motion from where programs start", "[unit][program]") {
  const std::string program = "PARTNO x\nRAPID\nGOTO/3,4,2\nFEDRAT/200\nGOTO/3,9,2\nFINI\n";
  const ForeignPath path = *Bench({program}).load().front();
  CHECK(path.start.assumed);
  CHECK(path.path->start == model::Vec3{0, 0, 10});
  REQUIRE(path.path->moves.size() == 2);
  CHECK(path.path->moves[0].to == model::Vec3{3, 4, 2});
  CHECK(path.path->moves[0].kind == model::MoveKind::rapid);
  const ForeignPath stated = *Bench({program}, "[machine]\nstart = [1, 2, 30]").load().front();
  CHECK(!stated.start.assumed);
  CHECK(stated.path->start == model::Vec3{1, 2, 30});
  CHECK(stated.path->moves.size() == 2);
}

TEST_CASE("FROM says where CL data start, unless the job does", "[unit][program]") {
  const std::string program = "UNITS/MM\nFROM/3,4,12\nRAPID\nGOTO/5,4,12\nFINI\n";
  const ForeignPath path = *Bench({program}).load().front();
  CHECK(!path.start.assumed);
  CHECK(path.start.at_mm == model::Vec3{3, 4, 12});
  CHECK(path.path->start == model::Vec3{3, 4, 12});
  const ForeignPath stated = *Bench({program}, "[machine]\nstart = [1, 2, 30]").load().front();
  CHECK(stated.start.at_mm == model::Vec3{1, 2, 30});
  CHECK(stated.path->start == model::Vec3{1, 2, 30});
  CHECK(says(stated, "line 2: FROM/3,4,12 is not acted on"));
  const ForeignPath same = *Bench({program}, "[machine]\nstart = [3, 4, 12]").load().front();
  CHECK(same.assumed.empty());
}

TEST_CASE("a target beyond 10 m is an error at its line", "[unit][program]") {
  CHECK_THAT(Bench({"G0 X0 Y0 Z9\nG0 X10000\nG0 X10001\n"}).error(),
             ContainsSubstring("p0.ngc:3:") &&
                 ContainsSubstring("error: the tip moves to x = 10001 mm in the frame of the cage; "
                                   "expected at most 10000 mm"));
  // An arc whose ends are near: its far side lies at x = 12000.
  CHECK_THAT(Bench({"G0 X9000 Y0 Z9 F9\nG3 X9000 Y10 I1500 J5\n"}).error(),
             ContainsSubstring("p0.ngc:2:"));
  CHECK(Bench({"G0 X9000 Y0 Z9\n"}, "[program_frame]\noffset = [900, 0, 0]").error() == "no error");
  CHECK_THAT(Bench({"G0 X9000 Y0 Z9\n"}, "[program_frame]\noffset = [1900, 0, 0]").error(),
             ContainsSubstring("x = 10900 mm"));
}

TEST_CASE("a cage with nothing to measure or too far away is bad input", "[unit][job]") {
  const tests::TemporaryFolder folder;
  const auto error_for = [&](const std::string& cage) {
    const std::string file = (folder.path() / "c.obj").string();
    std::ofstream(file) << cage;
    Job job = read(good_job());
    job.design->file = file;
    try {
      load_inputs(job, {kMemory});
    } catch (const model::InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string face = "f 1 2 3 4\n";
  CHECK_THAT(error_for("v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\n" + face),
             ContainsSubstring("c.obj") && ContainsSubstring("has no area"));
  CHECK_THAT(error_for("v 0 0 0\nv 0.1 0.3 0.7\nv 0.2 0.6 1.4\nv 0.3 0.9 2.1\n" + face),
             ContainsSubstring("has no area"));
  // Folded: there and back.
  CHECK_THAT(error_for("v 0 0 0\nv 9 0 0\nv 9 0 0\nv 0 0 0\n" + face),
             ContainsSubstring("has no area"));
  CHECK(error_for("v 0 0 0\nv 9 0 0\nv 9 0.01 0\nv 0 0.01 0\n" + face) == "no error");
  CHECK_THAT(error_for("# far\nv 0 0 0\n v 1e6 0 0\nv 9 9 0\nv 0 9 0\n" + face),
             ContainsSubstring("c.obj:3:2: error: the cage has a vertex at x = ") &&
                 ContainsSubstring("expected at most 10000 mm (10 m) from zero"));
}

}  // namespace limitgauge::app
