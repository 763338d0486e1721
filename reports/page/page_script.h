#pragma once

#include <iosfwd>

#include "reports/run/run_result.h"

namespace limitgauge::reports::page {

/// The page's data and script, for the end of its body (format: reports/web/README.md).
void write_page_script(const RunResult& result, std::ostream& out);

}  // namespace limitgauge::reports::page
