#include "app/run/pipeline.h"
#include "model/base/output_file.h"
#include "reports/run/report.h"

namespace limitgauge::app {

void write_report(const reports::RunResult& result, const std::filesystem::path& folder) {
  using Writer = void (*)(const reports::RunResult&, std::ostream&);
  const auto write = [&](const char* file, Writer writer) {
    model::write_file(folder / file, [&](std::ostream& out) { writer(result, out); });
  };
  write("report.html", reports::write_html);
  write("junit.xml", reports::write_junit);
  write("findings.sarif", reports::write_sarif);
  write("findings.csv", reports::write_findings_csv);
  // Last: what looks for a finished run looks for this file.
  write("result.json", reports::write_result_json);
}

}  // namespace limitgauge::app
