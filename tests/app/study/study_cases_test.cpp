#include "app/study/study_cases.h"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <sstream>

#include "app/output/byte_size.h"
#include "app/study/study_figures.h"
#include "app/study/study_output.h"
#include "model/base/error.h"
#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

std::string sample_text() {
  std::ostringstream out;
  write_result_json(reports::sample_result(reports::Outcome::passed), out);
  return std::move(out).str();
}

/// Puts the same result for every case, but for one that it loses.
class FakeExecutor : public study::Executor {
 public:
  explicit FakeExecutor(const study::Store& store) : store_(store), text_(sample_text()) {}
  void run(const std::vector<study::CaseRequest>& requests, const study::ReportOutcome& report,
           const std::atomic<bool>&) override {
    for (const study::CaseRequest& request : requests) {
      study::CaseOutcome outcome;
      outcome.index = request.index;
      outcome.reason = "gone";
      ++asked;
      if (request.index != lost) {
        store_.put("result", request.key, text_);
        outcome.ending = study::CaseOutcome::Ending::done;
        outcome.reason.clear();
      }
      report(outcome);
    }
  }
  std::size_t asked = 0;
  std::optional<std::size_t> lost;

 private:
  const study::Store& store_;
  std::string text_;
};

std::vector<study::Case> steps(const std::vector<std::string>& values) {
  std::vector<study::Case> cases;
  for (const std::string& value : values) cases.push_back({cases.size(), {{value, {}}}});
  return cases;
}

std::vector<study::Case> many_steps(std::size_t count) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::to_string(0.1 + 1e-5 * static_cast<double>(i)));
  return steps(values);
}

struct Bench {
  StudyCasesOptions options() {
    StudyCasesOptions options;
    options.job = tests::fixtures() / "jobs/quick-dome.toml";
    options.keys = {"stage.finish.step"};
    options.scope.stages = {"rough", "finish"};
    options.result = [this](std::size_t, const std::string&) { ++results; };
    options.progress = [this](const StudyProgress& at) { progress = at; };
    return options;
  }
  tests::TemporaryFolder folder;
  study::Store store{folder.path(), std::uint64_t{1} << 30};
  FakeExecutor executor{store};
  std::size_t results = 0;
  StudyProgress progress;
};

TEST_CASE("a row for every case, and work for those that nobody ran yet", "[unit][study]") {
  Bench bench;
  bench.executor.lost = 2;
  StudyCases cases(bench.options(), bench.store, bench.executor);
  const auto rows = cases.rows(steps({"0.5", "-1", "0.6", "0.7"}));
  REQUIRE(rows.size() == 4);
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i].asked.index == i);
  CHECK(rows[0].status == study::Status::pass);
  CHECK(rows[0].figures.size() == study_figures(bench.options().scope).size());
  CHECK(rows[1].status == study::Status::error);
  CHECK(rows[1].key.empty());
  CHECK_THAT(rows[1].reason, ContainsSubstring("step"));
  CHECK(rows[2].status == study::Status::lost);
  CHECK(rows[2].reason == "gone");
  CHECK(rows[3].status == study::Status::pass);
  CHECK(rows[0].key != rows[3].key);
  CHECK(bench.executor.asked == 3);
  CHECK(bench.results == 2);
  CHECK(bench.progress.ended == 4);
  CHECK(bench.progress.failed == 2);
  // Again, with one more: what was lost and what is new.
  bench.executor.lost.reset();
  StudyCases again(bench.options(), bench.store, bench.executor);
  const auto second = again.rows(steps({"0.5", "-1", "0.6", "0.7", "0.8"}));
  CHECK(bench.executor.asked == 3 + 2);
  CHECK(second[0].reused);
  CHECK(second[0].attempts == 0);
  CHECK_FALSE(second[2].reused);
  CHECK(second[2].status == study::Status::pass);
  CHECK(bench.progress.reused == 2);
}

TEST_CASE("settings that the job refuses in every case are bad input", "[unit][study]") {
  Bench bench;
  StudyCases cases(bench.options(), bench.store, bench.executor);
  CHECK_THROWS_AS(cases.rows(steps({"-1", "\"wide\""})), model::InputError);
  CHECK(cases.rows(steps({"0.5"})).size() == 1);
  // A search may well try a few that are refused on its way.
  CHECK(cases.rows(steps({"-1"})).front().status == study::Status::error);
}

TEST_CASE("ten times the cases take about ten times as long", "[unit][study]") {
  const auto seconds = [](std::size_t count) {
    Bench bench;
    const std::clock_t began = std::clock();  // of the processor: others do not count
    StudyCases first(bench.options(), bench.store, bench.executor);
    CHECK(first.rows(many_steps(count)).size() == count);
    StudyCases second(bench.options(), bench.store, bench.executor);
    CHECK(second.rows(many_steps(count)).size() == count);
    CHECK(bench.progress.reused == count);
    return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  };
  const double few = seconds(30), many = seconds(300);
  INFO(few << " s, " << many << " s");
  // A quadratic step would make it a hundred.
  CHECK(many < 30 * few + 0.3);
}

/// `LIMITGAUGE_CASES=10000 test_app "[.cases]"` says what that many take.
TEST_CASE("time that many cases take to be known, collected and reused", "[.cases]") {
  const char* stated = std::getenv("LIMITGAUGE_CASES");
  const auto count = static_cast<std::size_t>(stated != nullptr ? std::atoi(stated) : 1000);
  Bench bench;
  for (const char* what : {"collected", "reused"}) {
    const auto began = std::chrono::steady_clock::now();
    StudyCases cases(bench.options(), bench.store, bench.executor);
    CHECK(cases.rows(many_steps(count)).size() == count);
    WARN(count << " cases " << what << ": "
               << std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count()
               << " s");
  }
}

TEST_CASE("exit codes of a study", "[unit][study]") {
  using study::Status;
  const auto code = [](std::initializer_list<Status> statuses, bool recommended = false) {
    StudyOutcome outcome;
    for (const Status status : statuses) outcome.table.rows.emplace_back().status = status;
    if (recommended) outcome.analysis.recommendation.row = 0;
    return exit_code(outcome);
  };
  CHECK(code({Status::pass, Status::fail, Status::lost}, true) == ExitCode::pass);
  CHECK(code({Status::fail, Status::error, Status::lost}) == ExitCode::fail);
  CHECK(code({Status::error}) == ExitCode::fail);
  CHECK(code({Status::fail, Status::indeterminate}) == ExitCode::indeterminate);
  CHECK(code({Status::lost, Status::error}) == ExitCode::resources);
}

TEST_CASE("sizes as people write them", "[unit][study]") {
  CHECK(bytes_of_text("4G") == std::uint64_t{4} << 30);
  CHECK(bytes_of_text("500 MiB") == std::uint64_t{500} << 20);
  CHECK(bytes_of_text("1.5K") == 1536U);
  CHECK(bytes_of_text("1TB") == std::uint64_t{1} << 40);
  CHECK(bytes_of_text("0") == 0U);
  CHECK(bytes_of_text("12B") == 12U);
  for (const char* none : {"", "G", "-1", "4X", "4Gx", "nan", "inf", "1e300", "4 ", "0x10"})
    CHECK_FALSE(bytes_of_text(none));
}

}  // namespace
}  // namespace limitgauge::app
