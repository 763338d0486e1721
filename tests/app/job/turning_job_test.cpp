#include <algorithm>
#include <fstream>

#include "app/inputs/run_inputs.h"
#include "app/inputs/setup_view.h"
#include "app/job/job_reader.h"
#include "app/job/oriented_job.h"
#include "app/job/turning_stage.h"
#include "app/run/packed_path.h"
#include "app/run/result_parts.h"
#include "app/run/run_setups.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/messages.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

constexpr std::size_t kTurningMemory = std::size_t{1} << 33;

const std::string kTurningBegin = "G21 G90 G94\nT1 M6\nS1 M3\nG234 H1\nG0 X0 Y0 Z60\n";
const std::string kSimultaneous =
    kTurningBegin + "G1 Z30 F500\nX10 Z25 A20 C10\nY5 A25\nG0 Z60\nA0 C0\nG49\nM30\n";

/// The trunnion's job with another program, and what is changed of its text.
class TurningJob {
 public:
  explicit TurningJob(const std::string& program, const std::string& change = "",
                      const std::string& to = "", const std::string& file = "trunnion.nc") {
    std::string job = model::read_text_file(tests::fixtures() / "rotary/trunnion.toml");
    job = with(job, "../cages", (tests::fixtures() / "cages").string());
    if (!change.empty()) job = with(job, change, to);
    std::ofstream(folder_.path() / file) << program;
    std::ofstream(folder_.path() / "job.toml") << job;
  }
  Job read() const { return read_job(folder_.path() / "job.toml"); }
  RunInputs inputs() const { return load_inputs(read(), {kTurningMemory}); }
  std::string refusal() const {
    return tests::message_of<model::InputError>([this] { inputs(); });
  }

 private:
  tests::TemporaryFolder folder_;
};

bool is_told(const std::vector<std::string>& assumed, const std::string& part) {
  return std::ranges::any_of(
      assumed, [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

std::string many_times(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

}  // namespace

TEST_CASE("a stage that cuts while its axes turn stays one, in its own setup", "[unit][job]") {
  const Job job = TurningJob(kSimultaneous).read();
  REQUIRE(job.stages.size() == 1);
  const JobStage& stage = job.stages[0];
  CHECK(stage.name == "rough");
  CHECK(job.setups.size() == 1);
  CHECK(job.setups[stage.setup].setup.name == "vice");
  REQUIRE(stage.piece.has_value());
  CHECK(stage.piece->turns_while_cutting());
  CHECK(stage.piece->turning.size() == 3);
  CHECK(stage.piece->range.turns.empty());
  CHECK(stage.limits.has_uncut);
  CHECK_FALSE(only_positions(stage));
}

TEST_CASE("a program that only positions is taken apart, also where it feeds as it does",
          "[unit][job]") {
  // The tip stays where it is.
  const std::string swivels = kTurningBegin + "G1 Z30 F500\nA20\nX10\nG0 Z60\nA0\nM30\n";
  CHECK(TurningJob(swivels).read().stages.size() == 3);
  const std::string rapid = kTurningBegin + "G0 X10 A20\nG1 Z30 F500\nG0 Z60\nA0\nM30\n";
  CHECK(TurningJob(rapid).read().stages.size() == 3);
}

TEST_CASE("a program with many stretches is one stage that turns", "[unit][job]") {
  const std::string twice = "G1 Z31 F500\nG0 A1\nG1 Z30\nG0 A0\n";
  const auto stages_of = [&](int times) {
    return TurningJob(kTurningBegin + many_times(twice, times) + "M30\n").read().stages;
  };
  CHECK(stages_of(20).size() == 41);
  const std::vector<JobStage> many = stages_of(101);
  REQUIRE(many.size() == 1);
  CHECK(many[0].piece->turning.size() == 202);
}

TEST_CASE("a turning stage has a path with axes, which its pass has too", "[unit][job]") {
  const TurningJob file(kSimultaneous);
  const Job job = file.read();
  const RunInputs inputs = file.inputs();
  REQUIRE(inputs.programs[0].has_value());
  const ForeignPath& foreign = *inputs.programs[0];
  REQUIRE(foreign.axes != nullptr);
  CHECK_NOTHROW(require_axes(*foreign.path, *foreign.axes));
  CHECK(foreign.path->chord_error_mm > 0);
  CHECK(foreign.path->chord_error_mm <= inputs.settings.chord_error_mm[0]);
  CHECK(is_told(foreign.assumed, "turns of the tool while its tip stands still"));
  CHECK(is_told(result_as_asked(job, inputs, {}).assumptions, "evenly along a great circle"));
  CHECK_FALSE(result_as_asked(job, inputs, {}).stages[0].stretch.has_value());
  RunSetups setups(job, inputs);
  const StageToCut ready = setups.planner_at(0).plan(0, {}, {});
  CHECK(ready.axes == foreign.axes);
  setups.add(ready.path, ready.axes);
  CHECK(setups.passes_at(0)[0].axes == foreign.axes);
}

TEST_CASE("the last place of a turning path is where the program says", "[unit][job]") {
  const RunInputs inputs = TurningJob(kSimultaneous).inputs();
  const model::Toolpath& path = *inputs.programs[0]->path;
  CHECK(distance(path.moves.back().to, {10, 5, 60}) < 1e-9);
  CHECK(distance(inputs.programs[0]->axes->to.back(), {0, 0, 1}) < 1e-12);
}

TEST_CASE("what does not go with a tool that turns in the part is refused", "[unit][job]") {
  using Catch::Contains;
  const Job whole = TurningJob(kSimultaneous).read();
  const auto refusal = [&](const auto& change) {
    Job job = whole;
    change(job);
    return tests::message_of<model::InputError>(
        [&] { require_turning_tool(job, job.stages.front()); });
  };
  CHECK(refusal([](Job&) {}) == "no error");
  // Of CL data nothing says where the machine's axes stand.
  CHECK_THAT(refusal([](Job& job) {
               job.travel_mm.emplace();
               job.stages.front().piece.reset();
             }),
             Contains("the job has \"travel\""));
  CHECK_THAT(refusal([](Job& job) { job.tolerances.emplace(); }),
             Contains("a job without [tolerances]"));
  const auto with_body = [](FixtureMount mount) {
    return [mount](Job& job) { job.fixtures.push_back({"body", {}, {}, {}, {}, mount}); };
  };
  CHECK(refusal(with_body({})) == "no error");
  CHECK_THAT(refusal(with_body({FixtureMount::Kind::machine, {}})),
             Contains("fixture \"body\", which does not turn with the part"));
}

TEST_CASE("CL data with tool axes are a stage whose tool turns", "[unit][job]") {
  const TurningJob file(
      "UNITS/MM\nFROM/0,0,60\nRAPID\nGOTO/0,0,30,0.6,0,0.8\nFEDRAT/500\nGOTO/5,0,25,0,0,1\nFINI\n",
      "\"trunnion.nc\"", "\"five.apt\"", "five.apt");
  const Job job = file.read();
  REQUIRE(job.stages.size() == 1);
  CHECK_FALSE(job.stages[0].piece.has_value());
  const RunInputs inputs = file.inputs();
  REQUIRE(inputs.programs[0]->axes != nullptr);
  CHECK(inputs.programs[0]->axes->to.size() == 2);
  CHECK(is_told(inputs.programs[0]->assumed, "great circle between its ends"));
}

TEST_CASE("axes are packed to the last bit", "[unit]") {
  model::Toolpath path;
  path.moves.resize(2);
  const model::ToolAxes axes{{0.6, 0, 0.8}, {{0, 0.6, 0.8}, {0, 0, 1}}};
  model::Packer out;
  pack_axes(out, &axes);
  pack_axes(out, nullptr);
  const std::string bytes = out.take();
  model::Unpacker in(bytes);
  const auto read = unpack_axes(in, path);
  REQUIRE(read != nullptr);
  CHECK(read->start == axes.start);
  CHECK(read->to == axes.to);
  CHECK(unpack_axes(in, path) == nullptr);
  CHECK(in.done());
  path.moves.resize(3);
  model::Unpacker wrong(bytes);
  unpack_axes(wrong, path);
  CHECK_FALSE(wrong.good());
}

}  // namespace limitgauge::app
