#include "history/history.h"

#include <cmath>
#include <limits>

#include "history/recorder.h"
#include "tests/history/history_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::history {
namespace {

using tests::sample_entry;
using tests::TemporaryFolder;

std::vector<std::int64_t> ids(const std::vector<Entry>& entries) {
  std::vector<std::int64_t> all;
  for (const Entry& entry : entries) all.push_back(entry.id);
  return all;
}

/// A history of runs 1 to `count`, whose ids are their numbers.
std::filesystem::path filled(const TemporaryFolder& folder, int count) {
  const Recorder recorder(folder.path() / "runs.sqlite");
  for (int number = 1; number <= count; ++number) recorder.append(sample_entry(number));
  return recorder.file();
}

TEST_CASE("a run comes back as it was added", "[unit][history]") {
  const TemporaryFolder folder;
  const Recorder recorder(folder.path() / "runs.sqlite");
  Entry entry = sample_entry(7);
  entry.values[0].low = 0.1 + 0.2;
  entry.values[1].high = 5e-324;
  entry.id = recorder.append(entry);
  CHECK(entry.id == 1);
  CHECK(History(recorder.file()).runs({}) == std::vector<Entry>{entry});
}

TEST_CASE("text that looks like SQL or is none stays text", "[unit][history]") {
  const TemporaryFolder folder;
  const Recorder recorder(folder.path() / "a %?#'b.sqlite");
  Entry entry = sample_entry(1);
  entry.label = "'); DROP TABLE run; --";
  entry.commit = "\"; DELETE FROM value WHERE '1'='1";
  entry.job = "</script>\xff\xfe ?1 :a @b $c";
  entry.stages[0].stage = entry.values[0].stage = "x' OR 1=1; --";
  entry.values[1].metric = "m\nline";
  entry.id = recorder.append(entry);
  const History history(recorder.file());
  CHECK(history.runs({}) == std::vector<Entry>{entry});
  Query query;
  query.job = "' OR '1'='1";
  CHECK(history.runs(query).empty());
  query.job = entry.job;
  query.stages = {"x' OR 1=1; --"};
  query.metrics = {"m0"};
  REQUIRE(history.runs(query).size() == 1);
  CHECK(history.runs(query)[0].values == std::vector<Value>{entry.values[0]});
}

TEST_CASE("only what is asked for is read", "[unit][history]") {
  const TemporaryFolder folder;
  const History history(filled(folder, 9));
  Query query;
  query.job = "even";
  CHECK(ids(history.runs(query)) == std::vector<std::int64_t>{2, 4, 6, 8});
  query.last = 3;
  CHECK(history.count(query) == 4);
  CHECK(ids(history.runs(query)) == std::vector<std::int64_t>{4, 6, 8});
  query.since = "2026-11-18";
  CHECK(ids(history.runs(query)) == std::vector<std::int64_t>{8});
  query.job.reset();
  CHECK(ids(history.runs(query)) == std::vector<std::int64_t>{8, 9});
  query.stages = {"finish"};
  query.metrics = {"m1", "machining_time_s"};
  const std::vector<Entry> runs = history.runs(query);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].values ==
        std::vector<Value>{{"finish", "m1", 8.25, 8.5}, {"", "machining_time_s", 108, 108}});
  CHECK(runs[0].stages.size() == 2);
  query.last = 0;
  CHECK(history.runs(query).empty());
}

TEST_CASE("jobs and series are listed", "[unit][history]") {
  const TemporaryFolder folder;
  const History history(filled(folder, 3));
  CHECK(history.jobs() == std::vector<std::string>{"even", "odd"});
  const std::vector<Series> series = history.series();
  REQUIRE(series.size() == 7);
  CHECK(series.front() == Series{"", "machining_time_s"});
  CHECK(series.back() == Series{"rough", "m2"});
}

TEST_CASE("an open reader sees what is added meanwhile, and nothing is left beside the file",
          "[unit][history]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = filled(folder, 2);
  const History history(file);
  Recorder(file).append(sample_entry(3));
  CHECK(history.runs({}).size() == 3);
  CHECK(std::filesystem::directory_iterator(folder.path())->path() == file);
}

TEST_CASE("a run that does not fit is refused before anything is written", "[unit][history]") {
  const TemporaryFolder folder;
  const Recorder recorder(folder.path() / "runs.sqlite");
  Entry entry = sample_entry(1);
  entry.label = std::string(kLongestName + 1, 'x');
  CHECK_THROWS_AS(recorder.append(entry), std::invalid_argument);
  entry = sample_entry(1);
  entry.values[2].high = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(recorder.append(entry), std::invalid_argument);
  entry.values[2].high = std::nan("");
  CHECK_THROWS_AS(recorder.append(entry), std::invalid_argument);
  CHECK_FALSE(std::filesystem::exists(recorder.file()));
  entry = sample_entry(1);
  entry.values.push_back(entry.values[0]);
  CHECK_THROWS(recorder.append(entry));
  CHECK(History(recorder.file()).runs({}).empty());
}

TEST_CASE("a job's last runs are found through an index, without sorting", "[unit][history]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = filled(folder, 2);
  const std::string plan = tests::plan(
      file, "SELECT id, label FROM run WHERE true AND job = 'a' ORDER BY id DESC LIMIT 3");
  CHECK_THAT(plan, ContainsSubstring("USING INDEX run_of_job") && !ContainsSubstring("SCAN") &&
                       !ContainsSubstring("TEMP B-TREE"));
  CHECK_THAT(tests::plan(file, "SELECT low, high FROM value WHERE run = 1 AND series = 1"),
             ContainsSubstring("USING PRIMARY KEY (run=? AND series=?)"));
}

}  // namespace
}  // namespace limitgauge::history
