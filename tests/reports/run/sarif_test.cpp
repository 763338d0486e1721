#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "reports/run/report.h"
#include "reports/sarif/fingerprint.h"
#include "reports/sarif/places.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using nlohmann::json;

namespace {

std::string sarif_text_of(const RunResult& result) {
  std::ostringstream out;
  write_sarif(result, out);
  return out.str();
}

json run_of(const RunResult& result) {
  return json::parse(sarif_text_of(result))["runs"][0];
}

json results_of(const RunResult& result) {
  return run_of(result)["results"];
}

std::set<std::string> prints(const RunResult& result, const std::string& key) {
  std::set<std::string> out;
  for (const json& entry : results_of(result))
    if (entry["partialFingerprints"].contains(key))
      out.insert(entry["partialFingerprints"][key].get<std::string>());
  return out;
}

/// The program of the second stage with `count` lines before all others, as its findings see it.
RunResult shifted(RunResult result, std::uint32_t count) {
  StageRun& ran = *result.stages[1].ran;
  ran.program_text =
      std::make_shared<const std::string>(std::string(count, '\n') + *ran.program_text);
  for (auto* findings : {&ran.deviation->gouges, &ran.deviation->uncuts})
    for (verifier::Finding& f : *findings) f.line += count;
  for (simulator::Finding& f : ran.process) f.line += count;
  return result;
}

/// Every place and depth a little off, as another order of summation would leave them.
RunResult jittered(RunResult result, double by_mm) {
  verifier::StageDeviation& d = *result.stages[1].ran->deviation;
  for (auto* findings : {&d.gouges, &d.uncuts}) {
    for (verifier::Finding& f : *findings) {
      f.depth_mm += by_mm, f.place.point.x += by_mm;
      f.extent_mm.low.x += by_mm, f.extent_mm.high.y -= by_mm;
    }
  }
  return result;
}

}  // namespace

TEST_CASE("the hash is FNV-1a", "[unit][sarif]") {
  CHECK(sarif::hash_text("") == "cbf29ce484222325");
  CHECK(sarif::hash_text("a") == "af63dc4c8601ec8c");
  CHECK(sarif::hash_text("foobar") == "85944171f73967e8");
}

TEST_CASE("a line is known again by its words", "[unit][sarif]") {
  CHECK(sarif::normalised_line("N165 g1 X-4.5 (corner) Z0. ; down") == "G1X-4.5Z0.");
  CHECK(sarif::normalised_line("  G1X-4.5\tZ0.\r") == "G1X-4.5Z0.");
  CHECK(sarif::normalised_line("N") == "N");
  CHECK(sarif::normalised_line("(all comment)").empty());
}

TEST_CASE("fingerprints stay when lines shift, figures jitter or threads change",
          "[property][sarif]") {
  const RunResult result = sample_result(Outcome::failed, 21);
  const auto places = prints(result, "limitgaugePlace/v1");
  const auto lines = prints(result, "limitgaugeLine/v1");
  // A gouge and four findings of the process; the leftovers are within their limit.
  CHECK(places.size() == 6);
  CHECK(lines.size() >= 3);
  RunResult threads = result;
  threads.threads = 17, threads.created = "2030-01-01T00:00:00Z";
  for (const RunResult& other :
       {shifted(result, 12), jittered(result, 1e-9), jittered(result, -1e-9), threads}) {
    CHECK(prints(other, "limitgaugePlace/v1") == places);
    CHECK(prints(other, "limitgaugeLine/v1") == lines);
  }
  CHECK(sarif_text_of(threads) == sarif_text_of(result));
}

TEST_CASE("fingerprints tell stages, kinds and places apart", "[unit][sarif]") {
  ListedFinding finding;
  finding.kind = "gouge", finding.about = {10.1, 20.2, 3.3};
  const std::string print = sarif::place_fingerprint(finding, "finish");
  CHECK(sarif::place_fingerprint(finding, "rough") != print);
  ListedFinding other = finding;
  other.kind = "uncut";
  CHECK(sarif::place_fingerprint(other, "finish") != print);
  other = finding, other.about.y += 2;
  CHECK(sarif::place_fingerprint(other, "finish") != print);
  // Round coordinates lie well inside of a cell.
  for (const double x : {-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.5, 10.0}) {
    ListedFinding low = finding, high = finding;
    low.about.x = x - 1e-6, high.about.x = x + 1e-6;
    CHECK(sarif::place_fingerprint(low, "f") == sarif::place_fingerprint(high, "f"));
  }
}

TEST_CASE("findings in one cell are counted", "[unit][sarif]") {
  RunResult result = sample_result(Outcome::failed, 9);
  auto& gouges = result.stages[1].ran->deviation->gouges;
  gouges.push_back(gouges.front());
  std::multiset<std::string> ends;
  for (const json& entry : results_of(result))
    if (entry["ruleId"] == "gouge") {
      const std::string print = entry["partialFingerprints"]["primaryLocationLineHash"];
      ends.insert(print.substr(16));
    }
  CHECK(ends == std::multiset<std::string>{":1", ":2"});
}

TEST_CASE("a verdict that no finding explains is a result of its own", "[unit][sarif]") {
  RunResult result = sample_result(Outcome::passed, 9);
  CHECK(run_of(result)["results"].empty());
  result.stages[0].decision = {verifier::Verdict::fail, {"for a reason of its own"}};
  json results = results_of(result);
  REQUIRE(results.size() == 1);
  CHECK(results[0]["ruleId"] == "verdict");
  CHECK(results[0]["level"] == "error");
  CHECK_THAT(results[0]["message"]["text"].get<std::string>(),
             ContainsSubstring("for a reason of its own"));
  result.stages[0].ran->deviation->coverage = 0.5;
  results = results_of(result);
  REQUIRE(results.size() == 1);
  CHECK(results[0]["ruleId"] == "coverage");
  result.stages[0].decision = {verifier::Verdict::indeterminate, {"open"}};
  result.stages[0].ran->deviation->coverage = 1;
  CHECK(run_of(result)["results"][0]["level"] == "warning");
}

TEST_CASE("missing stock and what is out of reach are results", "[unit][sarif]") {
  RunResult result = sample_result(Outcome::passed, 9);
  StageResult& stage = result.stages[0];
  verifier::StageDeviation& d = *stage.ran->deviation;
  stage.decision = {verifier::Verdict::fail, {"for what follows"}};
  d.missing_stock_mm = {0.5, 0.51};
  d.missing_stock = {d.uncuts.front()};
  d.missing_stock[0].depth_mm = 0.5, d.missing_stock[0].line = 0;
  d.proven_reach = {90, 8, 2};
  d.surface_area_mm2 = 100;
  stage.limits.has_unreachable = stage.limits.has_unavoidable = true;
  stage.limits.unreachable = 0.05;
  stage.limits.unavoidable_mm = d.unavoidable_uncut_mm.low;
  const json results = results_of(result);
  REQUIRE(results.size() == 3);
  CHECK(results[0]["ruleId"] == "missing_stock");
  CHECK(results[0]["level"] == "error");
  CHECK(results[0]["properties"]["limit_mm"] == stage.limits.gouge_mm);
  CHECK(results[1]["ruleId"] == "unreachable");
  CHECK(results[1]["level"] == "error");
  CHECK_THAT(results[1]["message"]["text"].get<std::string>(), ContainsSubstring("limit 5 %"));
  CHECK(results[2]["ruleId"] == "unavoidable_uncut");
  CHECK(results[2]["level"] == "warning");
}

TEST_CASE("stages that were not run are told and not judged", "[unit][sarif]") {
  const json run = run_of(sample_result(Outcome::failed, 9));
  const json& notes = run["invocations"][0]["toolExecutionNotifications"];
  REQUIRE(notes.size() == 1);
  CHECK(notes[0]["message"]["text"] == "finish: not run");
  for (const json& entry : run["results"]) CHECK(entry["properties"]["stage"] == "semi-finish");
}

TEST_CASE("paths become URIs", "[unit][sarif]") {
  CHECK(sarif::uri_of("nc/part 1.ngc") == "nc/part%201.ngc");
  CHECK(sarif::uri_of("a:b#?%é") == "a%3Ab%23%3F%25%C3%A9");
  CHECK(sarif::uri_of("/nc/x.ngc") == "file:///nc/x.ngc");
}
