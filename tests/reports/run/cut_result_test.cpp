#include <nlohmann/json.hpp>
#include <sstream>

#include "model/base/error.h"
#include "reports/compare/run_comparison.h"
#include "reports/history/run_entry.h"
#include "reports/record/metrics.h"
#include "reports/record/record_reader.h"
#include "reports/run/gate_figures.h"
#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::reports {
namespace {

using CutJson = nlohmann::json;

std::string cut_text_by(void (*write)(const RunResult&, std::ostream&)) {
  std::ostringstream out;
  write(cut_result(), out);
  return std::move(out).str();
}

record::RunRecord record_of(const RunResult& result) {
  std::ostringstream out;
  write_result_json(result, out);
  std::istringstream in(std::move(out).str());
  return record::read_result_json(in, "result.json");
}

TEST_CASE("A result without a design has nothing that needs one", "[unit][cut]") {
  const CutJson json = CutJson::parse(cut_text_by(write_result_json));
  CHECK_FALSE(json.contains("surface"));
  for (const CutJson& stage : json["stages"]) {
    for (const char* key : {"deviation", "allowance_mm", "step_mm", "tolerance_mm", "strategy"})
      CHECK_FALSE(stage.contains(key));
    CHECK(stage["gate"].empty());
    CHECK(stage.contains("program"));
  }
  CHECK(json["stages"][0].contains("simulation"));
}

TEST_CASE("Without a design the gate's figures are counts of moves", "[unit][cut]") {
  const RunResult result = cut_result();
  for (const StageResult& stage : result.stages) {
    std::vector<std::string> names;
    for (const GateFigure& figure : gate_figures(stage)) names.push_back(figure.name);
    CHECK(names ==
          std::vector<std::string>{"rapid collisions", "holder collisions", "process faults"});
    CHECK(stage_notes(stage).empty());
  }
  const std::string junit = cut_text_by(write_junit);
  CHECK_THAT(junit, !ContainsSubstring("gouge") && !ContainsSubstring("allowance_mm") &&
                        ContainsSubstring("rapid collisions"));
  CHECK_THAT(cut_text_by(write_sarif), !ContainsSubstring("\"ruleId\": \"gouge\"") &&
                                           ContainsSubstring("rapid_through_stock"));
}

TEST_CASE("The page and the table say first that nothing was measured", "[unit][cut]") {
  const std::string page =
      cut_text_by([](const RunResult& result, std::ostream& out) { write_html(result, out, 2); });
  const std::string body =
      page.substr(page.find("<header>"), page.find("<nav") - page.find("<header>"));
  CHECK_THAT(body, ContainsSubstring("Nothing was measured against a design."));
  for (const char* absent : {"Error map in 3D", "id=\"surface\"", "<th>Gouge", "Coverage",
                             "Allowance", "<h3>Deviation", "<h3>Uncertainty", "<h3>Patches"})
    CHECK_THAT(page, !ContainsSubstring(absent));
  const std::string table = verdict_table(cut_result(), false, 200);
  CHECK_THAT(table, ContainsSubstring("nothing was measured against a design") &&
                        ContainsSubstring("removed") && !ContainsSubstring("gouge"));
}

TEST_CASE("A result without a design is read back without one", "[unit][cut][record]") {
  const record::RunRecord run = record_of(cut_result());
  CHECK_FALSE(run.cage);
  CHECK(run.diagonal_mm > 0);
  REQUIRE(run.stages[0].measures);
  CHECK_FALSE(run.stages[0].measures->deviation);
  CHECK_FALSE(run.stages[0].allowance_mm);
  std::vector<std::string> known;
  for (const record::Metric& metric : record::stage_metrics())
    if (metric.of(*run.stages[0].measures)) known.emplace_back(metric.id);
  CHECK(known == std::vector<std::string>{"removed_volume_mm3", "machining_time_s", "cut_length_mm",
                                          "rapid_length_mm", "moves", "seconds",
                                          "peak_memory_bytes"});
  for (const history::Value& value : history_report::entry_of(run).values)
    CHECK(value.metric != "resolution_mm");
}

TEST_CASE("Results are compared with others of their kind alone", "[unit][cut][compare]") {
  const record::RunRecord cut = record_of(cut_result());
  const record::RunRecord measured = record_of(foreign_result(3));
  const compare::Comparison same = compare::compare_runs(cut, cut, {});
  CHECK(same.judgement() == compare::Judgement::same);
  CHECK(same.stages[0].figures.size() == 7);
  record::RunRecord worse = cut;
  worse.stages[0].measures->process_findings.emplace_back().kind = "rapid_through_stock";
  worse.stages[0].measures->process.push_back({"rapid_through_stock", 1});
  CHECK(compare::compare_runs(cut, worse, {}).judgement() == compare::Judgement::worse);
  const std::string why =
      tests::message_of<model::InputError>([&] { compare::compare_runs(cut, measured, {}); });
  CHECK_THAT(why, ContainsSubstring("the base is of a program cut without a design and the new "
                                    "result was measured against a design"));
}

}  // namespace
}  // namespace limitgauge::reports
