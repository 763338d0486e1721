#pragma once

#include <iosfwd>
#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::page {

/// What stands in the page's two elements of data (format: reports/web/README.md). The same result
/// gives the same bytes.
struct PageData {
  std::string json;  ///< safe inside a script element
  std::string blob;  ///< base64
};
PageData page_data(const RunResult& result);

/// The page's data and script, for the end of its body (format: reports/web/README.md).
void write_page_script(const RunResult& result, std::ostream& out);

}  // namespace limitgauge::reports::page
