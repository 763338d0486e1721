#pragma once

#include <string>
#include <string_view>

#include "reports/history/figure_column.h"
#include "reports/history/job_history.h"

namespace limitgauge::reports::history_report {

/// The verdict as a badge; a word that is none, as text.
std::string verdict_badge(std::string_view verdict);

/// The runs of the job as a table, newest first; a row has the id `run-ID`.
std::string runs_table(const JobHistory& job, std::size_t index);

}  // namespace limitgauge::reports::history_report
