#include <signal.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/e2e/program.h"
#include "tests/e2e/running_program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// A grid over the finishing pass of the quick job.
std::string study_of(const std::string& steps, const std::string& tolerances = "0.01, 0.02") {
  return "name = \"grid\"\njob = \"" + fixture("jobs/quick-dome.toml") +
         "\"\n[[vary]]\nkey = \"stage.finish.step\"\nvalues = [" + steps +
         "]\n[[vary]]\nkey = \"stage.finish.tolerance\"\nvalues = [" + tolerances + "]\n";
}

std::vector<std::string> arguments(const std::string& output,
                                   const std::vector<std::string>& more = {}) {
  return coarsely({"study", "study.toml", "-o", output, "--cache", "cache"}, more);
}

json study_in(const fs::path& folder) {
  return json::parse(read_text(folder / "study.json"));
}

/// What may differ between two runs of the same study.
json without_run(json study) {
  study.erase("run");
  return study;
}

std::size_t results_in(const fs::path& cache) {
  std::error_code ignored;
  std::size_t count = 0;
  if (!fs::exists(cache / "result")) return 0;
  for (const auto& entry : fs::recursive_directory_iterator(cache / "result", ignored))
    count += entry.is_regular_file() && entry.path().filename().string().front() != '.';
  return count;
}

bool wait_until(const std::function<bool()>& there) {
  for (int i = 0; i < 3000; ++i) {
    if (there()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

std::vector<pid_t> children_of(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) +
                   "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; in >> child;) children.push_back(child);
  return children;
}

std::size_t files_called(const fs::path& folder, const std::string& name) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.path().filename() == name;
  return count;
}

TEST_CASE("a study has a row for every case, and repeats no work", "[e2e][slow][study]") {
  const Scratch scratch;
  write_text(scratch / "study.toml", study_of("1, 2.4, -1"));
  const Outcome first = limitgauge(scratch, arguments("first"));
  INFO(first.errors);
  REQUIRE(first.exit_code == 0);
  CHECK(first.errors.empty());
  CHECK_THAT(first.out, ContainsSubstring("6 cases") && ContainsSubstring("2 error") &&
                            ContainsSubstring("0 reused, 4 run") &&
                            ContainsSubstring("recommended: case") &&
                            ContainsSubstring("stage.finish.step = 1") &&
                            ContainsSubstring((scratch / "first/study.html").string()));
  CHECK(files_called(scratch / "first", "result.json") == 4);
  for (const char* file : {"study.csv", "study.json", "study.html"})
    CHECK(fs::file_size(scratch / "first" / file) > 500);
  CHECK(results_in(scratch / "cache") == 4);
  CHECK(study_in(scratch / "first").dump().find("step") != std::string::npos);

  const Outcome second = limitgauge(scratch, arguments("second"));
  CHECK(second.exit_code == 0);
  CHECK_THAT(second.out, ContainsSubstring("4 reused, 0 run"));
  CHECK(without_run(study_in(scratch / "second")) == without_run(study_in(scratch / "first")));

  // Of the same folder only where it is told so.
  CHECK(limitgauge(scratch, arguments("second")).exit_code == 3);
  CHECK(limitgauge(scratch, arguments("second", {"--force"})).exit_code == 0);
}

TEST_CASE("a study in which nothing passes", "[e2e][study]") {
  const Scratch scratch;
  write_text(scratch / "study.toml", study_of("2.4", "0.01"));
  const Outcome none = limitgauge(scratch, arguments("none"));
  CHECK(none.exit_code == 1);
  CHECK_THAT(none.out, ContainsSubstring("1 fail") && !ContainsSubstring("recommended:"));
}

TEST_CASE("a study that cannot be run writes nothing", "[e2e][study]") {
  const Scratch scratch;
  write_text(scratch / "study.toml", study_of("-1, -2"));
  const Outcome refused = limitgauge(scratch, arguments("out"));
  CHECK(refused.exit_code == 3);
  write_text(scratch / "study.toml", study_of("1"));
  CHECK(limitgauge(scratch, arguments("out", {"--set", "stage.finish.stop=1"})).exit_code == 3);
  CHECK(limitgauge(scratch, arguments("out", {"--cache-limit", "many"})).exit_code == 3);
  CHECK(limitgauge(scratch, {"study", "none.toml"}).exit_code == 3);
  CHECK(limitgauge(scratch, {"study", "study.toml", "--cache", "study.toml/x"}).exit_code == 3);
  CHECK_FALSE(fs::exists(scratch / "out"));
  CHECK(results_in(scratch / "cache") == 0);
}

TEST_CASE("an interrupted study goes on where it was", "[e2e][slow][study]") {
  const Scratch scratch;
  write_text(scratch / "study.toml", study_of("1, 1.1"));
  RunningProgram program(scratch, arguments("out", {"--quiet"}));
  REQUIRE(wait_until([&] { return results_in(scratch / "cache") >= 1; }));
  const std::vector<pid_t> workers = children_of(program.id());
  CHECK_FALSE(workers.empty());
  CHECK(program.end(SIGTERM) == 4);
  for (const pid_t worker : workers) CHECK(kill(worker, 0) != 0);
  CHECK(scratch.entries() == std::vector<std::string>{"cache", "study.toml"});
  const std::size_t kept = results_in(scratch / "cache");
  REQUIRE(kept < 4);
  const Outcome rest = limitgauge(scratch, arguments("out"));
  CHECK(rest.exit_code == 0);
  CHECK_THAT(rest.out, ContainsSubstring(std::to_string(kept) + " reused, " +
                                         std::to_string(4 - kept) + " run"));
  // Killed hard, it leaves no workers behind either.
  write_text(scratch / "study.toml", study_of("1.05"));
  RunningProgram killed(scratch, arguments("out2", {"--quiet"}));
  REQUIRE(wait_until([&] { return !children_of(killed.id()).empty(); }));
  const std::vector<pid_t> orphans = children_of(killed.id());
  CHECK(killed.end(SIGKILL) == -SIGKILL);
  for (const pid_t orphan : orphans)
    CHECK(wait_until([&] { return !fs::exists("/proc/" + std::to_string(orphan) + "/exe"); }));
}

TEST_CASE("a killed worker's case is run again", "[e2e][slow][study]") {
  const Scratch scratch;
  write_text(scratch / "study.toml", study_of("1"));
  RunningProgram program(scratch, arguments("out", {"--jobs", "1"}));
  REQUIRE(wait_until([&] { return !children_of(program.id()).empty(); }));
  CHECK(kill(children_of(program.id()).front(), SIGKILL) == 0);
  CHECK_THAT(program.line(), ContainsSubstring("2 pass"));
  CHECK(program.end(0) == 0);
  // Without another try it is lost, and the rest is not.
  write_text(scratch / "study.toml", study_of("1.2"));
  RunningProgram once(scratch, arguments("out2", {"--jobs", "1", "--retries", "0"}));
  REQUIRE(wait_until([&] { return !children_of(once.id()).empty(); }));
  CHECK(kill(children_of(once.id()).front(), SIGKILL) == 0);
  CHECK_THAT(once.line(), ContainsSubstring("1 pass, 1 lost"));
  CHECK_THAT(once.line(), ContainsSubstring("signal 9"));
  CHECK(once.end(0) == 0);
}

TEST_CASE("two studies share a cache at the same time", "[e2e][slow][study]") {
  const Scratch scratch;
  write_text(scratch / "study.toml", study_of("1"));
  RunningProgram one(scratch, arguments("one", {"--jobs", "1"}));
  RunningProgram other(scratch, arguments("other", {"--jobs", "1"}));
  CHECK_THAT(one.line(), ContainsSubstring("2 pass"));
  CHECK_THAT(other.line(), ContainsSubstring("2 pass"));
  CHECK(one.end(0) == 0);
  CHECK(other.end(0) == 0);
  CHECK(without_run(study_in(scratch / "one")) == without_run(study_in(scratch / "other")));
  CHECK(results_in(scratch / "cache") == 2);
}

}  // namespace
}  // namespace limitgauge::e2e
