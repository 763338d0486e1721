#include "reports/page/page_script.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "reports/embedded.h"

namespace limitgauge::reports::page {

std::string content_policy() {
  return "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src 'sha256-" +
         std::string(embedded::report_js_sha256()) + "'";
}

void write_page_script(const RunResult& result, std::ostream& out) {
  const nlohmann::json data = {{"format", "limitgauge.page/1"}, {"job", result.job}};
  std::string text = data.dump();
  // Inside a script element nothing but "<" can end or nest it.
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  out << "<script type=\"application/json\" id=\"limitgauge-report\">" << text << "</script>\n"
      << "<script>" << embedded::report_js() << "</script>\n";
}

}  // namespace limitgauge::reports::page
