#include <signal.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/e2e/running_program.h"
#include "tests/study/fake_slurm.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
namespace {

using study::FakeSlurm;

void write_slurm_study(const Scratch& scratch) {
  write_text(scratch / "study.toml", "name = \"slurm\"\njob = \"" +
                                         fixture("jobs/quick-dome.toml") +
                                         "\"\n[[vary]]\nkey = \"stage.finish.step\"\n"
                                         "values = [1, 2]\n");
}

std::vector<std::string> on_slurm(const std::string& output) {
  return {"study", "study.toml",       "-o",  output, "--engine", "slurm", "--cache",
          "cache", "--slurm-patience", "0.02"};
}

TEST_CASE("a study ends with what it has when a node of Slurm does not come back", "[e2e][study]") {
  const Scratch scratch;
  write_slurm_study(scratch);
  const FakeSlurm slurm;
  slurm.set_queue("1 0 RUNNING|n1|long|None\n1 1 COMPLETING|n1|long|None\n");
  slurm.set_nodes("long|up|n1|down*\n");
  const auto began = std::chrono::steady_clock::now();
  const Outcome outcome = limitgauge(scratch, on_slurm("out"));
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(60));
  CHECK(outcome.exit_code == 4);
  CHECK_THAT(outcome.errors,
             ContainsSubstring("has not come back for 0.02 min (RUNNING on node n1, "
                               "which is down*)"));
  const std::string table = read_text(scratch / "out/study.csv");
  CHECK_THAT(table, ContainsSubstring("lost") && ContainsSubstring("COMPLETING on node n1"));
  CHECK(fs::exists(scratch / "out/study.html"));
}

TEST_CASE("a study cancels the jobs of one that was killed", "[e2e][study]") {
  const Scratch scratch;
  write_slurm_study(scratch);
  const FakeSlurm slurm;
  slurm.set_queue("1 0 PENDING||long|Priority\n1 1 PENDING||long|Priority\n");
  RunningProgram killed(scratch, on_slurm("killed"));
  for (int i = 0; i < 500 && slurm.calls("sbatch").empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(killed.end(SIGKILL) == -SIGKILL);
  REQUIRE(slurm.calls("sbatch").size() == 1);
  const std::string left =
      fs::directory_iterator(scratch / "cache/slurm")->path().filename().string();
  RunningProgram next(scratch, on_slurm("next"));
  for (int i = 0; i < 500 && slurm.calls("sbatch").size() < 2; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto cancelled = slurm.calls("scancel");
  CHECK(std::find(cancelled.begin(), cancelled.end(), "--name=" + left) != cancelled.end());
  CHECK_FALSE(fs::exists(scratch / "cache/slurm" / left));
}

}  // namespace
}  // namespace limitgauge::e2e
