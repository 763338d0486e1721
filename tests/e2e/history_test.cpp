#include <nlohmann/json.hpp>
#include <thread>

#include "tests/e2e/program.h"
#include "tests/e2e/running_program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// What differs from run to run without any history.
void strip(json& value) {
  for (const char* key : {"created", "seconds", "peak_memory_bytes"})
    if (value.is_object()) value.erase(key);
  if (value.is_structured())
    for (json& one : value) strip(one);
}

json result_of(const fs::path& folder) {
  json result = json::parse(read_text(folder / "result.json"));
  strip(result);
  return result;
}

TEST_CASE("a history holds the runs and changes nothing of their results", "[e2e][history]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, run_coarse_job("plain")).exit_code == 0);
  const Outcome kept = limitgauge(
      scratch,
      run_coarse_job("kept", {"--history", "runs.sqlite", "--label", "a", "--commit", "0123abcd"}));
  CHECK(kept.exit_code == 0);
  CHECK_THAT(kept.out, ContainsSubstring("history: runs.sqlite, run 1\n"));
  CHECK(scratch.entries() == std::vector<std::string>{"kept", "plain", "runs.sqlite"});
  // But for the label, which stands in the result, too.
  json labelled = result_of(scratch / "kept");
  CHECK(labelled["label"] == "a");
  labelled.erase("label");
  CHECK(labelled == result_of(scratch / "plain"));
  for (const char* name : {"findings.csv", "findings.sarif", "finish/toolpath.ngc",
                           "finish/deviation.vtp", "finish/stock.vtp", "rough/toolpath.vtp"})
    CHECK(read_text(scratch / "kept" / name) == read_text(scratch / "plain" / name));
  // A run that fails its gate is one of the history, too.
  CHECK(limitgauge(scratch, run_coarse_job("fails", {"--history", "runs.sqlite", "--set",
                                                     "stage.rough.gate.uncut=0.1", "--quiet"}))
            .exit_code == 1);
  REQUIRE(limitgauge(scratch, {"history", "runs.sqlite", "-o", "list"}).exit_code == 0);
  const json job = json::parse(read_text(scratch / "list/history.json"))["jobs"][0];
  REQUIRE(job["runs"].size() == 2);
  CHECK(job["runs"][0]["commit"] == "0123abcd");
  CHECK(job["runs"][1]["verdict"] == "fail");
  CHECK(job["runs"][1]["stages"][1]["verdict"] == "not_run");
  const json uncut =
      json::parse(read_text(scratch / "kept/result.json"))["stages"][1]["deviation"]["uncut_mm"];
  const json& series = job["series"].back();
  CHECK(series["stage"] == "finish");
  CHECK(series["values"][0]["low"] == uncut["low"]);
  CHECK(series["values"][0]["high"] == uncut["high"]);
  CHECK(series["values"][1].is_null());
}

TEST_CASE("a history that is damaged is said before anything is done", "[e2e][history]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, run_coarse_job("first", {"--history", "runs.sqlite"})).exit_code ==
          0);
  const std::string whole = read_text(scratch / "runs.sqlite");
  write_text(scratch / "runs.sqlite",
             whole.substr(0, whole.size() - 4096) + std::string(4096, 'x'));
  const Outcome outcome =
      limitgauge(scratch, run_coarse_job("second", {"--history", "runs.sqlite"}));
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.errors, ContainsSubstring("runs.sqlite: error: this history is damaged"));
  CHECK(scratch.entries() == std::vector<std::string>{"first", "runs.sqlite"});
}

TEST_CASE("a history that breaks while a run goes on loses no result", "[e2e][history]") {
  const Scratch scratch;
  RunningProgram program(scratch, run_coarse_job("out", {"--history", "runs.sqlite"}));
  // The working folder is made after the history was seen to be in order.
  while (scratch.entries().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  write_text(scratch / "runs.sqlite", "no longer what it was");
  CHECK(program.end(0) == 4);
  CHECK(json::parse(read_text(scratch / "out/result.json"))["verdict"] == "pass");
  CHECK(read_text(scratch / "runs.sqlite") == "no longer what it was");
}

}  // namespace
}  // namespace limitgauge::e2e
