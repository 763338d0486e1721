#pragma once

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

}  // namespace limitgauge::reports::page
