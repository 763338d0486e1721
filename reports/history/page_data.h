#pragma once

#include <string>

#include "reports/history/job_history.h"

namespace limitgauge::reports::history_report {

/// The overview as JSON, format `limitgauge.history/1`; `indent` −1: on one line.
std::string overview_json(const Overview& overview, int indent);

}  // namespace limitgauge::reports::history_report
