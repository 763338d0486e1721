#include "study/execute/local_pool.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "model/base/error.h"
#include "study/execute/memory_budget.h"
#include "study/execute/worker_lines.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::study {
namespace {

namespace fs = std::filesystem;
using Ending = CaseOutcome::Ending;

std::vector<CaseRequest> plain_cases(std::size_t count) {
  std::vector<CaseRequest> requests(count);
  for (std::size_t i = 0; i < count; ++i) {
    requests[i].index = i;
    requests[i].key = std::string(64, 'a');
    requests[i].prefixes = {"p"};
    requests[i].overrides = {"stage.a.step=" + std::to_string(i)};
  }
  return requests;
}

/// A worker that is a shell: `body` sees $index, $folder, and answers by `say KIND PEAK REASON`.
LocalPoolOptions shell_pool(const fs::path& folder, const std::string& body) {
  LocalPoolOptions options;
  options.worker = {"/bin/sh", "-c",
                    "folder=$1; tab=$(printf '\\t')\n"
                    "say() { printf '%s\\t%s\\t0.5\\t%s\\t%s\\tend\\n' \"$1\" \"$index\" \"$2\" "
                    "\"$3\"; }\n"
                    "while IFS=\"$tab\" read -r kind index key rest; do\n" +
                        body + "\ndone",
                    "worker", folder.string()};
  options.memory_bytes = 1 << 20;
  options.forecast_bytes = [](const CaseRequest&) { return std::uint64_t{1}; };
  return options;
}

std::map<std::size_t, CaseOutcome> outcomes_of(LocalPoolOptions options, std::size_t cases) {
  const std::atomic<bool> stop{false};
  std::map<std::size_t, CaseOutcome> outcomes;
  LocalPool pool(std::move(options));
  pool.run(
      plain_cases(cases),
      [&](const CaseOutcome& outcome) {
        CHECK(outcomes.try_emplace(outcome.index, outcome).second);
      },
      stop);
  return outcomes;
}

TEST_CASE("lines between a pool and its workers", "[unit][study]") {
  const WorkerTask task{7, std::string(64, 'f'), {"a.b=\"x\ty\\n\"", "c=1\n", "", "end"}};
  std::string line = to_line(task);
  CHECK(line.back() == '\n');
  CHECK(line.find('\n') + 1 == line.size());
  line.pop_back();
  const auto read = task_of_line(line);
  REQUIRE(read);
  CHECK(read->index == 7);
  CHECK(read->key == task.key);
  CHECK(read->overrides == task.overrides);
  const WorkerAnswer answer{3, WorkerAnswer::Kind::error, 0.1, 1U << 31U, "job.toml:3:1: \t; no"};
  std::string said = to_line(answer);
  said.pop_back();
  const auto heard = answer_of_line(said);
  REQUIRE(heard);
  CHECK(heard->index == 3);
  CHECK(heard->kind == WorkerAnswer::Kind::error);
  CHECK(heard->seconds == 0.1);
  CHECK(heard->peak_bytes == 1U << 31U);
  CHECK(heard->reason == answer.reason);
  // A line that was cut short is none.
  for (std::size_t length = 0; length < said.size(); ++length)
    CHECK_FALSE(answer_of_line(said.substr(0, length)));
  for (const char* none : {"", "end", "done\tx\t1\t1\t\tend", "well\t1\t1\t1\t\tend"})
    CHECK_FALSE(answer_of_line(none));
}

TEST_CASE("a pool runs every case once and tells how it ended", "[unit][study]") {
  const tests::TemporaryFolder folder;
  LocalPoolOptions options =
      shell_pool(folder.path(),
                 "echo \"$index\" >> \"$folder/ran\"\n"
                 "case $index in 3) say error 10 'no such tool' ;; 5) say again 10 'disk full' ;; "
                 "*) say done 10 '' ;; esac");
  options.workers = 4;
  const auto outcomes = outcomes_of(options, 20);
  REQUIRE(outcomes.size() == 20);
  for (const auto& [index, outcome] : outcomes) {
    CHECK(outcome.ending == (index == 3 || index == 5 ? Ending::error : Ending::done));
    CHECK(outcome.attempts == (index == 5 ? 3 : 1));
    CHECK(outcome.seconds == 0.5);
  }
  CHECK(outcomes.at(3).reason == "no such tool");
  CHECK(outcomes.at(5).reason == "disk full");
  std::ifstream in(folder.path() / "ran");
  std::size_t ran = 0;
  for (std::string line; std::getline(in, line);) ++ran;
  CHECK(ran == 22);
}

TEST_CASE("a case whose worker dies is tried again, and lost in the end", "[unit][study]") {
  const tests::TemporaryFolder folder;
  // 2 dies once; 4 always, each time otherwise; the others take no harm.
  LocalPoolOptions options =
      shell_pool(folder.path(),
                 "if [ $index = 2 ] && mkdir \"$folder/died\" 2>/dev/null; then kill -9 $$; fi\n"
                 "if [ $index = 4 ]; then if [ -d \"$folder/first\" ]; then exit 7; fi; "
                 "mkdir \"$folder/first\"; kill -11 $$; fi\n"
                 "say done 10 ''");
  options.workers = 2;
  options.retries = 1;
  std::vector<std::string> notes;
  options.note = [&notes](const std::string& note) { notes.push_back(note); };
  const auto outcomes = outcomes_of(options, 8);
  REQUIRE(outcomes.size() == 8);
  CHECK(outcomes.at(2).ending == Ending::done);
  CHECK(outcomes.at(2).attempts == 2);
  CHECK(outcomes.at(4).ending == Ending::lost);
  CHECK(outcomes.at(4).attempts == 2);
  CHECK_THAT(outcomes.at(4).reason, ContainsSubstring("exit code 7"));
  for (const std::size_t index : {0, 1, 3, 5, 6, 7}) CHECK(outcomes.at(index).attempts == 1);
  REQUIRE(notes.size() == 3);
  const std::string all = notes[0] + notes[1] + notes[2];
  CHECK_THAT(all, ContainsSubstring("signal 9") && ContainsSubstring("signal 11"));
}

TEST_CASE("a worker that cannot be started is an error of its own", "[unit][study]") {
  LocalPoolOptions options = shell_pool("/", "");
  options.worker = {"/no/such/program"};
  CHECK_THROWS_AS(outcomes_of(options, 1), model::ResourceError);
}

TEST_CASE("a pool that is stopped ends its workers", "[unit][study]") {
  const tests::TemporaryFolder folder;
  LocalPoolOptions options =
      shell_pool(folder.path(), "echo $$ > \"$folder/$index\"; exec sleep 60");
  options.workers = 2;
  std::atomic<bool> stop{false};
  std::thread stopper([&] {
    while (!fs::exists(folder.path() / "0") || !fs::exists(folder.path() / "1"))
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    stop = true;
  });
  LocalPool pool(options);
  const auto began = std::chrono::steady_clock::now();
  CHECK_THROWS_AS(pool.run(
                      plain_cases(2), [](const CaseOutcome&) { FAIL("ended"); }, stop),
                  model::Interrupted);
  stopper.join();
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(30));
  for (const char* name : {"0", "1"}) {
    pid_t process = 0;
    std::ifstream(folder.path() / name) >> process;
    REQUIRE(process > 0);
    CHECK(kill(process, 0) != 0);
  }
}

TEST_CASE("cases wait for memory, by what others took", "[unit][study]") {
  const tests::TemporaryFolder folder;
  // Each says how many are at work with it.
  const auto most_at_once = [&](std::uint64_t forecast, std::uint64_t peak) {
    const fs::path own = folder.path() / std::to_string(forecast) / std::to_string(peak);
    fs::create_directories(own);
    LocalPoolOptions options = shell_pool(own,
                                          "mkdir \"$folder/at-$index\"; ls -d \"$folder\"/at-* "
                                          "2>/dev/null | wc -l >> \"$folder/seen\"; "
                                          "sleep 0.05; rmdir \"$folder/at-$index\"; say done " +
                                              std::to_string(peak) + " ''");
    options.workers = 4;
    options.memory_bytes = 1000;
    options.forecast_bytes = [forecast](const CaseRequest&) { return forecast; };
    CHECK(outcomes_of(options, 12).size() == 12);
    std::ifstream in(own / "seen");
    int most = 0;
    for (int number = 0; in >> number;) most = std::max(most, number);
    return most;
  };
  // One case runs in any case, one that was forecast to be too much.
  CHECK(most_at_once(5000, 5000) == 1);
  CHECK(most_at_once(500, 450) == 2);
  // What is forecast too high is put right.
  CHECK(most_at_once(5000, 100) > 2);
}

TEST_CASE("ten thousand cases go through a pool", "[property][study]") {
  const tests::TemporaryFolder folder;
  LocalPoolOptions options = shell_pool(folder.path(), "say done 10 ''");
  options.workers = 2;
  CHECK(outcomes_of(options, 10000).size() == 10000);
}

}  // namespace
}  // namespace limitgauge::study
