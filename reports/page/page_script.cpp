#include "reports/page/page_script.h"

#include <ostream>

#include "reports/page/page_data.h"
#include "reports/text/embedded.h"

namespace limitgauge::reports::page {

void write_page_script(const RunResult& result, std::ostream& out) {
  const PageData data = page_data(result);
  out << "<script type=\"application/json\" id=\"limitgauge-report\">" << data.json << "</script>\n"
      << "<script type=\"application/octet-stream\" id=\"limitgauge-blob\">" << data.blob
      << "</script>\n<script>" << embedded::report_js() << "</script>\n";
}

}  // namespace limitgauge::reports::page
