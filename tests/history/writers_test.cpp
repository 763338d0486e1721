#include <signal.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "history/history.h"
#include "history/recorder.h"
#include "tests/history/history_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::history {
namespace {

using tests::query;
using tests::sample_entry;
using tests::TemporaryFolder;

constexpr int kFigures = 30;
const std::string kFiguresOfARun = std::to_string(2 * kFigures + 1);

/// Every run that is there is whole: all its figures, both its stages.
void check_whole(const std::filesystem::path& file) {
  CHECK(query(file, "PRAGMA integrity_check") == "ok");
  CHECK(query(file,
              "SELECT count(*) FROM run WHERE (SELECT count(*) FROM value WHERE run = run.id) <> " +
                  kFiguresOfARun + " OR (SELECT count(*) FROM stage WHERE run = run.id) <> 2") ==
        "0");
  CHECK(query(file, "SELECT count(*) FROM value WHERE run NOT IN (SELECT id FROM run)") == "0");
}

TEST_CASE("runs of writers at the same time are all there, ids rising", "[unit][history]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "runs.sqlite";
  constexpr int kWriters = 4, kRuns = 15;
  // None has made the file: they fight for that, too.
  std::vector<int> children;
  for (int writer = 0; writer < kWriters; ++writer) {
    children.push_back(tests::start_child([&, writer] {
      std::int64_t last = 0;
      for (int i = 0; i < kRuns; ++i) {
        const std::int64_t id = Recorder(file).append(sample_entry(100 * writer + i, kFigures));
        if (id <= last) return 1;
        last = id;
      }
      return 0;
    }));
  }
  for (const int child : children) CHECK(tests::wait_for(child) == 0);
  check_whole(file);
  const std::vector<Entry> runs = History(file).runs({});
  REQUIRE(runs.size() == kWriters * kRuns);
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    CHECK(runs[i].id == static_cast<std::int64_t>(i) + 1);
    labels.push_back(runs[i].label);
  }
  std::sort(labels.begin(), labels.end());
  CHECK(std::adjacent_find(labels.begin(), labels.end()) == labels.end());
}

TEST_CASE("a writer that is killed leaves whole runs and no lock", "[unit][history]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "runs.sqlite";
  std::size_t before = 0;
  // On a busy machine a child may not come to its first run in as long: then it is given longer.
  for (int round = 0; round < 25 || (before == 0 && round < 400); ++round) {
    const int child = tests::start_child([&] {
      for (int i = 0;; ++i) Recorder(file).append(sample_entry(i, kFigures));
      return 0;
    });
    // Spread over what an append takes, the making of the file among it.
    std::this_thread::sleep_for(std::chrono::microseconds(500 + 1700 * round));
    kill(child, SIGKILL);
    REQUIRE(tests::wait_for(child) == -SIGKILL);
    if (!std::filesystem::exists(file)) continue;
    const std::size_t now = History(file).runs({}).size();
    CHECK(now >= before);
    before = now;
  }
  Recorder(file).append(sample_entry(1, kFigures));
  CHECK(History(file).runs({}).size() == before + 1);
  CHECK(before > 0);
  check_whole(file);
}

TEST_CASE("a file whose maker was killed while it wrote is an empty history", "[unit][history]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "runs.sqlite";
  const int child = tests::start_child([&] {
    sqlite3* handle = nullptr;
    sqlite3_open(file.c_str(), &handle);
    // More than the cache holds: pages are in the file before the journal is done with.
    sqlite3_exec(handle,
                 "PRAGMA cache_size = 4; BEGIN IMMEDIATE; CREATE TABLE run (x);"
                 "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 500)"
                 "INSERT INTO run SELECT randomblob(1000) FROM n",
                 nullptr, nullptr, nullptr);
    return raise(SIGKILL);
  });
  REQUIRE(tests::wait_for(child) == -SIGKILL);
  REQUIRE(std::filesystem::file_size(file) > 0);
  REQUIRE(std::filesystem::exists(file.string() + "-journal"));
  const bool writes_first = GENERATE(true, false);
  if (!writes_first) CHECK(History(file).runs({}).empty());
  Recorder(file).append(sample_entry(1, kFigures));
  CHECK(History(file).runs({}).size() == 1);
  check_whole(file);
}

TEST_CASE("readers beside a writer see whole runs", "[unit][history]") {
  const TemporaryFolder folder;
  const Recorder recorder(folder.path() / "runs.sqlite");
  recorder.append(sample_entry(0, kFigures));
  const int child = tests::start_child([&] {
    for (int i = 1; i < 40; ++i) recorder.append(sample_entry(i, kFigures));
    return 0;
  });
  std::size_t seen = 0;
  while (seen < 40) {
    const std::vector<Entry> runs = History(recorder.file()).runs({});
    REQUIRE(runs.size() >= seen);
    seen = runs.size();
    for (const Entry& run : runs) REQUIRE(run.values.size() == 2 * kFigures + 1);
  }
  CHECK(tests::wait_for(child) == 0);
}

}  // namespace
}  // namespace limitgauge::history
