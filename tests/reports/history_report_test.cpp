#include "reports/history/history_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/history/figure_column.h"
#include "reports/history/run_entry.h"
#include "tests/reports/sample_history.h"
#include "tests/support/catch.h"

namespace limitgauge::reports::history_report {
namespace {

using compare::Judgement;
using nlohmann::json;

std::string text_of(void (*write)(const Overview&, std::ostream&), const Overview& overview) {
  std::ostringstream out;
  write(overview, out);
  return out.str();
}

std::size_t column(const JobHistory& job, const std::string& stage, const std::string& metric) {
  for (std::size_t i = 0; i < job.columns.size(); ++i)
    if (job.columns[i].stage == stage && job.columns[i].metric == metric) return i;
  throw std::runtime_error("no column " + stage + " " + metric);
}

std::vector<std::string> titles(const JobHistory& job) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < job.columns.size(); ++i) all.push_back(FigureColumn(job, i).title());
  return all;
}

record::RunRecord sample_record() {
  record::RunRecord run;
  run.job = "part";
  run.version = "0.1.0";
  run.created = "2026-11-22T01:00:00Z";
  run.verdict = verifier::Verdict::fail;
  record::StageRecord& rough = run.stages.emplace_back();
  rough.name = "rough";
  rough.verdict = verifier::Verdict::fail;
  rough.limits.has_gouge = true;
  rough.limits.gouge_mm = 0.05;
  record::StageMeasures& measures = rough.measures.emplace();
  record::DeviationMeasures& deviation = measures.deviation.emplace();
  deviation.gouge_mm = {0.06, 0.07};
  deviation.uncut_mm = {0.1, 0.2};
  measures.machining_time_s = 12.5;
  deviation.resolution_mm = 0.01;
  measures.voxel_mm = 0.25;
  run.stages.emplace_back().name = "finish";
  return run;
}

TEST_CASE("an entry holds every metric, the limits that are stated, and the verdicts",
          "[unit][history]") {
  const history::Entry entry = entry_of(sample_record());
  CHECK(entry.job == "part");
  CHECK(entry.created == "2026-11-22T01:00:00Z");
  CHECK(entry.verdict == "fail");
  CHECK(entry.stages ==
        std::vector<history::StageVerdict>{{"rough", "fail"}, {"finish", "not_run"}});
  // All metrics of the one stage that was run but the three over tolerances, of which there are
  // none; its one limit, its fineness, and the whole's time.
  CHECK(entry.values.size() == record::stage_metrics().size() - 3 + 1 + 2 + 1);
  const auto has = [&](const history::Value& value) {
    return std::count(entry.values.begin(), entry.values.end(), value) == 1;
  };
  CHECK(has({"", "machining_time_s", 12.5, 12.5}));
  CHECK(has({"rough", "gouge_mm", 0.06, 0.07}));
  CHECK(has({"rough", "gouge_limit_mm", 0.05, 0.05}));
  CHECK(has({"rough", "voxel_mm", 0.25, 0.25}));
}

TEST_CASE("runs stand by job, with the usual figures or those that are chosen", "[unit][history]") {
  std::vector<history::Entry> runs = sample_runs(4);
  runs[1].job = "wing";
  const Overview usual = overview_of(runs);
  REQUIRE(usual.jobs.size() == 2);
  CHECK(usual.jobs[0].job == "aircraft");
  CHECK(usual.jobs[0].runs.size() == 3);
  CHECK(usual.jobs[1].runs.front().entry.id == 2);
  CHECK(titles(usual.jobs[0]) == std::vector<std::string>{"machining time", "rough gouge",
                                                          "rough uncut", "finish gouge",
                                                          "finish uncut"});
  CHECK(titles(overview_of(runs, {{"finish"}, {}}).jobs[0]) ==
        std::vector<std::string>{"finish gouge", "finish uncut", "finish machining time"});
  CHECK(titles(overview_of(runs, {{}, {"voxel_mm", "coverage"}}).jobs[0]) ==
        std::vector<std::string>{"rough coverage", "rough voxel_mm", "finish coverage",
                                 "finish voxel_mm"});
}

TEST_CASE("trends tell better from worse, and both from what the certificate cannot tell",
          "[unit][history]") {
  const JobHistory job = overview_of(sample_runs(40)).jobs[0];
  const std::size_t uncut = column(job, "finish", "uncut_mm");
  const std::size_t time = column(job, "", "machining_time_s");
  const auto judged = [&](int run, std::size_t at) { return job.runs[run].cells[at].judgement; };
  CHECK_FALSE(judged(0, uncut));
  CHECK(judged(1, uncut) == Judgement::same);
  CHECK(judged(6, uncut) == Judgement::worse);
  CHECK(job.runs[6].cells[uncut].direction == 1);
  CHECK(judged(7, uncut) == Judgement::better);
  CHECK(job.runs[6].cells[uncut].limit == 0.01);
  // Run 10 has no finish: the next one is held against the one before.
  CHECK_FALSE(job.runs[10].cells[uncut].value);
  CHECK(judged(11, uncut) == Judgement::same);
  CHECK(judged(20, time) == Judgement::better);
  // Run 21 stopped at the rough: its time is that of another job.
  CHECK_FALSE(judged(21, time));
  CHECK(judged(22, time) == Judgement::same);
  // Less than the resolution, upwards: nothing is known of it.
  std::vector<history::Entry> runs = sample_runs(2);
  for (history::Value& value : runs[1].values)
    if (value.metric == "uncut_mm") value.low += 0.0004, value.high += 0.0004;
  CHECK(overview_of(runs).jobs[0].runs[1].cells[uncut].judgement == Judgement::same);
}

TEST_CASE("no trend leads from one meaning of gouge and uncut to another", "[unit][history]") {
  std::vector<history::Entry> runs = sample_runs(8);
  CHECK_FALSE(overview_of(runs).jobs[0].changes_meaning());
  for (int run = 0; run < 6; ++run) runs[run].result_schema = 1;
  const Overview overview = overview_of(runs);
  const JobHistory& job = overview.jobs[0];
  CHECK(job.changes_meaning());
  const std::size_t uncut = column(job, "finish", "uncut_mm");
  const std::size_t time = column(job, "", "machining_time_s");
  // Run 6 would be worse than run 5 by far.
  CHECK(job.runs[6].cells[uncut].new_meaning);
  CHECK_FALSE(job.runs[6].cells[uncut].judgement);
  CHECK(job.runs[6].cells[uncut].direction == 0);
  CHECK(job.runs[7].cells[uncut].judgement == Judgement::better);
  CHECK(job.runs[6].cells[time].judgement == Judgement::same);
  CHECK_THAT(history_table(overview, false),
             ContainsSubstring("[27.0, 28.0] new meaning") && ContainsSubstring(kNewMeaning));
  CHECK_THAT(text_of(write_history_html, overview),
             ContainsSubstring("No trend is drawn across that."));
  CHECK_THAT(text_of(write_history_csv, overview), ContainsSubstring("\"new meaning\""));
  const json all = json::parse(text_of(write_history_json, overview));
  CHECK(all["jobs"][0]["series"][4]["values"][6]["trend"] == "new meaning");
  CHECK(all["jobs"][0]["runs"][5]["result_schema"] == "limitgauge.result/1");
  CHECK(all["jobs"][0]["runs"][6]["result_schema"] == "limitgauge.result/2");
}

TEST_CASE("the table names run, time, commit, verdict and the last stage's figures",
          "[unit][history]") {
  const std::string table = history_table(overview_of(sample_runs(8)), false);
  CHECK_THAT(table, ContainsSubstring("aircraft: 8 runs"));
  CHECK_THAT(table, ContainsSubstring("run  date, UTC") && ContainsSubstring("machining time, s") &&
                        ContainsSubstring("finish uncut, µm") && !ContainsSubstring("rough"));
  CHECK_THAT(table,
             ContainsSubstring("2026-01-04 09:30") && ContainsSubstring("[27.0, 28.0] ↑ worse"));
  CHECK_THAT(table,
             ContainsSubstring("[7.0, 8.0] ↓ better") && ContainsSubstring("[7.0, 8.0] =\n"));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) CHECK(code_points(line) <= 130);
  const std::string coloured = history_table(overview_of(sample_runs(8)), true);
  CHECK_THAT(coloured, ContainsSubstring("\x1b[1;31m↑ worse\x1b[0m"));
}

TEST_CASE("history.csv holds a row a figure, texts safe for spreadsheets", "[unit][history]") {
  std::vector<history::Entry> runs = sample_runs(7);
  runs[0].label = "=1+1,\"x\"";
  const std::string csv = text_of(write_history_csv, overview_of(runs));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 7 * 5);
  CHECK_THAT(csv, ContainsSubstring("run,created,job,version,commit,label,run_verdict,stage,metric,"
                                    "low,high,limit,trend\r\n1,\"2026-01-01T09:30:00Z\","
                                    "\"aircraft\",\"0.1.0\",") &&
                      ContainsSubstring(",\"'=1+1,\"\"x\"\"\",\"pass\",\"\",\"machining_time_s\","
                                        "2100,2100,,\"\"\r\n") &&
                      ContainsSubstring("\"fail\",\"finish\",\"uncut_mm\",0.027,0.028,0.01,"
                                        "\"worse\"\r\n"));
}

TEST_CASE("history.json holds the runs and their figures in all their digits", "[unit][history]") {
  const json all = json::parse(text_of(write_history_json, overview_of(sample_runs(12))));
  CHECK(all["schema"] == "limitgauge.history/1");
  const json& job = all["jobs"][0];
  CHECK(job["runs"][10]["stages"][1] == json{{"name", "finish"}, {"verdict", "not_run"}});
  const json& uncut = job["series"][4];
  CHECK(uncut["metric"] == "uncut_mm");
  CHECK(uncut["source"] == "certified");
  CHECK(uncut["values"][6] ==
        json{{"low", 0.027}, {"high", 0.028}, {"limit", 0.01}, {"trend", "worse"}});
  CHECK(uncut["values"][10].is_null());
  CHECK(uncut["values"].size() == job["runs"].size());
}

TEST_CASE("the page holds every run without its script", "[unit][history]") {
  const std::string page = text_of(write_history_html, overview_of(sample_runs(40)));
  const std::string body = page.substr(0, page.find("<script"));
  for (int id = 1; id <= 40; ++id)
    CHECK_THAT(body, ContainsSubstring("<tr role=\"row\" id=\"run-" + std::to_string(id) + "\""));
  CHECK_THAT(body, ContainsSubstring("[27.0, 28.0]<small class=\"worse\">limit 10</small>") &&
                       ContainsSubstring("↑ worse") && ContainsSubstring("nightly 3"));
}

TEST_CASE("markup in labels, commits and names stays text", "[unit][history]") {
  const std::string page = text_of(write_history_html, hostile_overview());
  const std::string body =
      page.substr(page.find("<body"), page.rfind("<script>") - page.find("<body"));
  CHECK_THAT(body, !ContainsSubstring("<img") && !ContainsSubstring("<svg") &&
                       ContainsSubstring("&lt;img src=x onerror=window.hostile=1&gt;"));
  // One end of the data, one of the script.
  std::size_t ends = 0;
  for (std::size_t at = 0; (at = page.find("</script", at)) != std::string::npos; ++at) ++ends;
  CHECK(ends == 2);
  CHECK(json::parse(text_of(write_history_json, hostile_overview())).is_object());
  CHECK_NOTHROW(history_table(hostile_overview(), true));
}

}  // namespace
}  // namespace limitgauge::reports::history_report
