#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "reports/history/job_history.h"

namespace limitgauge::reports::history_report {

/// For a terminal: a table a job, in colour where asked for. Without a choice it holds the figures
/// of the last stage.
std::string history_table(const Overview& overview, bool colour);

/// history.csv, RFC 4180: a row a figure of a run.
void write_history_csv(const Overview& overview, std::ostream& out);
/// history.json, schema `limitgauge.history/1`; the page's data are the same.
void write_history_json(const Overview& overview, std::ostream& out);
/// history.html, one self-contained page: a section a job.
void write_history_html(const Overview& overview, std::ostream& out);

/// The overview as JSON, format `limitgauge.history/1`; `indent` −1: on one line.
std::string overview_json(const Overview& overview, int indent);

}  // namespace limitgauge::reports::history_report
