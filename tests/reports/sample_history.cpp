#include "tests/reports/sample_history.h"

#include <array>
#include <cstdio>

namespace limitgauge::reports {
namespace {

using history::Entry;

std::string two(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/// Two runs a day.
std::string created(int number) {
  const int day = number / 2;
  return "2026-" + two(1 + day / 28) + "-" + two(1 + day % 28) + "T" +
         (number % 2 == 0 ? "09:30:00Z" : "17:05:00Z");
}

/// 40 hexadecimal digits that differ in the first.
std::string commit(int number) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%08x%032x", 0x9e3779b1U * static_cast<unsigned>(number),
                static_cast<unsigned>(number));
  return text.data();
}

void add_stage(Entry& run, const std::string& stage, double uncut_mm, double limit_mm,
               double time_s) {
  const auto add = [&](const char* metric, double low, double high) {
    run.values.push_back({stage, metric, low, high});
  };
  add("gouge_mm", 0, limit_mm / 20);
  add("uncut_mm", uncut_mm, uncut_mm + limit_mm / 10);
  add("coverage", uncut_mm > limit_mm ? 0.982 : 0.9995, uncut_mm > limit_mm ? 0.982 : 0.9995);
  add("machining_time_s", time_s, time_s);
  add("gouge_limit_mm", limit_mm, limit_mm);
  add("uncut_limit_mm", limit_mm, limit_mm);
  add("coverage_limit", 0.99, 0.99);
  add("resolution_mm", limit_mm / 10, limit_mm / 10);
  add("voxel_mm", 0.1, 0.1);
}

Entry sample_run(int number, int count) {
  Entry run;
  run.id = number + 1;
  run.created = created(number);
  run.job = "aircraft";
  run.version = "0.1.0";
  run.commit = commit(number + 1);
  if (number % 10 == 0) run.label = "nightly " + std::to_string(number / 10);
  const bool stopped = number % 11 == 10, left = number % 7 == 6;
  run.verdict = stopped || left ? "fail" : "pass";
  run.stages = {{"rough", stopped ? "fail" : "pass"},
                {"finish", stopped ? "not_run"
                           : left  ? "fail"
                                   : "pass"}};
  const double finish_s = number < count / 2 ? 1200 : 1140;
  add_stage(run, "rough", stopped ? 0.7 : 0.4, 0.5, 900);
  if (!stopped) add_stage(run, "finish", left ? 0.027 : 0.007, 0.01, finish_s);
  const double whole_s = stopped ? 900 : 900 + finish_s;
  run.values.push_back({"", "machining_time_s", whole_s, whole_s});
  return run;
}

}  // namespace

std::vector<Entry> sample_runs(int count) {
  std::vector<Entry> runs;
  for (int number = 0; number < count; ++number) runs.push_back(sample_run(number, count));
  return runs;
}

history_report::Overview overview_of(const std::vector<Entry>& runs,
                                     const history_report::Choice& choice) {
  history_report::Overview overview;
  overview.file = "runs.sqlite";
  overview.version = "0.1.0";
  overview.found = runs.size();
  overview.choice = choice;
  overview.jobs = history_report::job_histories(runs, choice);
  return overview;
}

history_report::Overview hostile_overview() {
  const std::string markup = "</script><img src=x onerror=window.hostile=1>";
  const std::string drawing = "\"'><svg onload=window.hostile=1>&lt;b&gt;\xff\x01";
  std::vector<Entry> runs = sample_runs(3);
  for (Entry& run : runs) {
    run.job = markup + run.job;
    run.commit = drawing;
    run.label = markup + drawing;
    run.created = run.created.substr(0, 10) + drawing;
    run.version = drawing;
    run.stages[1].stage = markup;
    for (history::Value& value : run.values)
      if (value.stage == "finish") value.stage = markup;
  }
  runs[1].verdict = drawing;
  runs[1].stages[0].verdict = markup;
  history_report::Choice choice{{}, {"gouge_mm", "uncut_mm", drawing}};
  runs[2].values.push_back({markup, drawing, 1, 2});
  history_report::Overview overview = overview_of(runs, choice);
  overview.file = markup + ".sqlite";
  return overview;
}

}  // namespace limitgauge::reports
