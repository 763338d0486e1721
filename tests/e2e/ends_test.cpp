#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>

#include "tests/e2e/program.h"
#include "tests/e2e/running_program.h"
#include "tests/support/catch.h"

/// How the program ends where the machine does not carry it, or where it is told to.
namespace limitgauge::e2e {
namespace {

namespace fs = std::filesystem;
using Out = Conditions::Out;

/// A job of one stage that passes.
std::vector<std::string> run_small_job(const std::string& output,
                                       const std::vector<std::string>& more) {
  std::vector<std::string> command{
      "run",   fixture("findings/near-miss-clean.toml"), "-o", output, "--no-pictures",
      "--set", "stage.channel.gate.uncut=0.02"};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

Conditions with(Out out) {
  Conditions conditions;
  conditions.out = out;
  return conditions;
}

TEST_CASE("standard output that fails is an error, and nothing else is lost", "[e2e][ends]") {
  const Out out = GENERATE(Out::full, Out::pipe_nobody_reads, Out::closed);
  const Scratch scratch;
  const Outcome run =
      limitgauge(scratch, run_small_job("out", {"--history", "runs.sqlite"}), with(out));
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.errors, ContainsSubstring("standard output cannot be written: "));
  CHECK(scratch.entries() == std::vector<std::string>{"out", "runs.sqlite"});
  CHECK(read_text(scratch / "out/result.json").find("\"verdict\": \"pass\"") != std::string::npos);
  const Outcome history = limitgauge(scratch, {"history", "runs.sqlite", "-o", "listing"});
  CHECK_THAT(history.out, ContainsSubstring("near-miss-clean: 1 run"));
  // Nobody who is told nothing misses anything.
  CHECK(limitgauge(scratch, run_small_job("quiet", {"--quiet"}), with(out)).exit_code == 0);
}

TEST_CASE("what every command prints is missed where it is lost", "[e2e][ends]") {
  const Scratch scratch;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"--version"},
        {"run", "--help"},
        {"inspect", fixture("cages/quick-dome.obj")},
        {"inspect", fixture("programs/good/absolute-centres.ngc"), "--moves"}}) {
    CAPTURE(command);
    CHECK(limitgauge(scratch, command).exit_code == 0);
    CHECK(limitgauge(scratch, command, with(Out::full)).exit_code == 4);
    CHECK(limitgauge(scratch, command, with(Out::pipe_nobody_reads)).exit_code == 4);
  }
}

/// A job that anybody may read and run, whoever has made the folders of this test.
void copy_job(const Scratch& scratch) {
  fs::copy_file(fixture("jobs/quick-dome.toml"), scratch / "jobs/quick-dome.toml");
  fs::copy_file(fixture("cages/quick-dome.obj"), scratch / "cages/quick-dome.obj");
}

TEST_CASE("threads that cannot be started end a run with the reason", "[e2e][ends]") {
  const Scratch scratch;
  for (const char* folder : {"jobs", "cages"}) fs::create_directory(scratch / folder);
  copy_job(scratch);
  fs::permissions(scratch.path(), fs::perms::all);
  // From none at all to those of some library that is started late.
  for (const std::size_t most : {1, 5, 6, 8, 9, 10}) {
    Conditions conditions;
    conditions.most_threads = most;
    const std::string name = "out" + std::to_string(most);
    const Outcome run = limitgauge(
        scratch,
        {"run", "jobs/quick-dome.toml", "-o", name, "--quiet", "--no-pictures", "--threads", "4"},
        conditions);
    CAPTURE(most, run.errors);
    CHECK((run.exit_code == 4 || (most > 1 && run.exit_code == 0)));
    CHECK(fs::exists(scratch / name) == (run.exit_code == 0));
    if (run.exit_code == 4) CHECK_THAT(run.errors, ContainsSubstring("no thread can be started: "));
  }
}

TEST_CASE("descriptors and memory that run out end a run with the reason", "[e2e][ends]") {
  constexpr std::size_t kMega = 1000 * 1000;
  const Scratch scratch;
  int ended = 0;
  const auto try_with = [&](const Conditions& conditions, const std::string& reason) {
    const Outcome run = limitgauge(scratch,
                                   {"run", fixture("jobs/quick-dome.toml"), "-o", "out", "--quiet",
                                    "--no-pictures", "--threads", "2", "--force"},
                                   conditions);
    CAPTURE(conditions.most_descriptors.value_or(0), conditions.most_memory_bytes.value_or(0),
            run.errors);
    // The loader of the libraries that the program is linked with has words of its own.
    if (run.exit_code == 127) return;
    CHECK((run.exit_code == 0 || run.exit_code == 4));
    if (run.exit_code == 4) CHECK_THAT(run.errors, ContainsSubstring(reason));
    ended += run.exit_code == 4 ? 1 : 0;
  };
  for (const std::size_t most : {4, 5, 6}) {
    Conditions conditions;
    conditions.most_descriptors = most;
    try_with(conditions, "Too many open files");
  }
  CHECK(ended > 0);
  ended = 0;
  for (const std::size_t mega : {200, 280, 360}) {
    Conditions conditions;
    conditions.most_memory_bytes = mega * kMega;
    try_with(conditions, "");
  }
  CHECK(ended > 0);
}

TEST_CASE("Ctrl-C and SIGTERM end a command that looks at nothing", "[e2e][ends][stop]") {
  using Clock = std::chrono::steady_clock;
  // What is promised are two seconds; the machine may be busy with other tests.
  constexpr std::chrono::seconds kMost{15};
  const int signal = GENERATE(SIGINT, SIGTERM);
  const Scratch scratch;
  // Somebody holds them open and never writes: the program waits for the system to let it go on.
  for (const char* pipe : {"waits.ngc", "waits.obj", "waits.toml"}) {
    REQUIRE(mkfifo((scratch / pipe).c_str(), 0600) == 0);
    REQUIRE(open((scratch / pipe).c_str(), O_RDWR | O_CLOEXEC) >= 0);
  }
  const auto is_pipe = [](const std::string& word) { return word.rfind("waits", 0) == 0; };
  for (const std::vector<std::string>& command : {std::vector<std::string>{"inspect", "waits.ngc"},
                                                  {"inspect", "waits.obj"},
                                                  {"run", "waits.toml", "-o", "out"}}) {
    CAPTURE(command);
    RunningProgram program(scratch, command);
    REQUIRE(program.opens(scratch / *std::find_if(command.begin(), command.end(), is_pipe)));
    const auto told = Clock::now();
    CHECK(program.end(signal) == 4);
    CHECK(Clock::now() - told < kMost);
  }
  CHECK_FALSE(fs::exists(scratch / "out"));
}

}  // namespace
}  // namespace limitgauge::e2e
