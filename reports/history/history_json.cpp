#include <nlohmann/json.hpp>
#include <ostream>

#include "reports/history/figure_column.h"
#include "reports/history/history_report.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const history::Entry& run) {
  Json stages = Json::array();
  for (const history::StageVerdict& one : run.stages)
    stages.push_back({{"name", clean_text(one.stage)}, {"verdict", clean_text(one.verdict)}});
  return {{"id", run.id},
          {"created", clean_text(run.created)},
          {"version", clean_text(run.version)},
          {"commit", clean_text(run.commit)},
          {"label", clean_text(run.label)},
          {"verdict", clean_text(run.verdict)},
          {"result_schema", "limitgauge.result/" + std::to_string(run.result_schema)},
          {"stages", std::move(stages)}};
}

const char* source_name(const Column& column) {
  return column.known == nullptr ? "unknown" : record::name(column.known->source);
}

Json cell_json(const Cell& cell) {
  if (!cell.value) return nullptr;
  Json json = {{"low", cell.value->low}, {"high", cell.value->high}};
  if (cell.limit) json["limit"] = *cell.limit;
  if (const std::string word = trend_word(cell); !word.empty()) json["trend"] = word;
  return json;
}

Json series_json(const JobHistory& job, std::size_t i) {
  const Column& column = job.columns[i];
  Json values = Json::array();
  for (const Run& run : job.runs) values.push_back(cell_json(run.cells[i]));
  return {{"stage", clean_text(column.stage)}, {"metric", clean_text(column.metric)},
          {"label", clean_text(column.label)}, {"unit", column.unit},
          {"source", source_name(column)},     {"values", std::move(values)}};
}

Json job_json(const JobHistory& job) {
  Json runs = Json::array(), series = Json::array();
  for (const Run& run : job.runs) runs.push_back(run_json(run.entry));
  for (std::size_t i = 0; i < job.columns.size(); ++i) series.push_back(series_json(job, i));
  return {{"job", clean_text(job.job)}, {"runs", std::move(runs)}, {"series", std::move(series)}};
}

}  // namespace

std::string overview_json(const Overview& overview, int indent) {
  Json jobs = Json::array();
  for (const JobHistory& job : overview.jobs) jobs.push_back(job_json(job));
  const Json json = {{"schema", "limitgauge.history/1"},
                     {"file", clean_text(overview.file)},
                     {"version", overview.version},
                     {"found", overview.found},
                     {"jobs", std::move(jobs)}};
  return json.dump(indent);
}

void write_history_json(const Overview& overview, std::ostream& out) {
  out << overview_json(overview, 1) << '\n';
}

}  // namespace limitgauge::reports::history_report
