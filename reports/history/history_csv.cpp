#include <ostream>

#include "model/text/number_text.h"
#include "reports/history/figure_column.h"
#include "reports/history/history_report.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {
namespace {

constexpr const char* kHeader =
    "run,created,job,version,commit,label,run_verdict,stage,metric,low,high,limit,trend\r\n";

std::string run_cells(const JobHistory& job, const history::Entry& run) {
  return std::to_string(run.id) + "," + csv_text_cell(run.created) + "," + csv_text_cell(job.job) +
         "," + csv_text_cell(run.version) + "," + csv_text_cell(run.commit) + "," +
         csv_text_cell(run.label) + "," + csv_text_cell(run.verdict);
}

std::string figure_cells(const Column& column, const Cell& cell) {
  return csv_text_cell(column.stage) + "," + csv_text_cell(column.metric) + "," +
         model::shortest(cell.value->low) + "," + model::shortest(cell.value->high) + "," +
         (cell.limit ? model::shortest(*cell.limit) : std::string()) + "," +
         csv_text_cell(trend_word(cell));
}

}  // namespace

void write_history_csv(const Overview& overview, std::ostream& out) {
  out << kHeader;
  for (const JobHistory& job : overview.jobs)
    for (const Run& run : job.runs) {
      const std::string head = run_cells(job, run.entry);
      for (std::size_t i = 0; i < job.columns.size(); ++i)
        if (run.cells[i].value)
          out << head << "," << figure_cells(job.columns[i], run.cells[i]) << "\r\n";
    }
}

}  // namespace limitgauge::reports::history_report
