#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "model/base/run_control.h"
#include "reports/html/job/job_sections.h"
#include "reports/html/markup.h"
#include "reports/html/masthead.h"
#include "reports/html/shell.h"
#include "reports/html/stage/stage_parts.h"
#include "reports/html/tolerance_line.h"
#include "reports/page/page_data.h"
#include "reports/run/report.h"
#include "reports/text/embedded.h"

namespace limitgauge::reports {
namespace {

using namespace html;

std::string head(const RunResult& result) {
  const std::string css = std::string(embedded::script_css()).append(tolerance_style(result));
  return shell_head(result.job + ": " + word(result.verdict),
                    {embedded::report_js(), embedded::report_js_sha256(), css});
}

/// Where the page's script shows the part; without it the maps of the stages say the same.
constexpr const char* kView =
    "<section id=\"view\"><h2>Error map in 3D</h2>\n<noscript><p class=\"note\">The map that can "
    "be "
    "turned needs a script, which is switched off here. Each stage below has its map as a "
    "picture.</p></noscript>\n<div data-view=\"\"></div></section>\n";

constexpr const char* kStockView =
    "<section id=\"view\"><h2>Finished stock in 3D</h2>\n<noscript><p class=\"note\">The stock "
    "that "
    "can be turned needs a script, which is switched off here. Each stage below has it as a "
    "picture.</p></noscript>\n<div data-view=\"\"></div></section>\n";

/// What takes time, side by side: the sections of all stages, with their maps, then the script.
std::vector<std::string> large_parts(const RunResult& result, unsigned threads) {
  const std::size_t stages = result.stages.size();
  std::vector<std::string> parts(stages + 1);
  model::parallel_for(parts.size(), threads, [&](std::size_t i) {
    if (i < stages) {
      parts[i] = stage_section(result, i);
      return;
    }
    std::ostringstream script;
    page::write_page_script(result, script);
    parts[i] = std::move(script).str();
  });
  return parts;
}

}  // namespace

void write_html(const RunResult& result, std::ostream& out, unsigned threads) {
  const std::vector<std::string> parts = large_parts(result, threads);
  out << head(result) << masthead(result) << contents(result)
      << "<main id=\"figures\" tabindex=\"-1\">\n"
      << stage_table(result) << (result.surface ? kView : kStockView);
  for (std::size_t i = 0; i < result.stages.size(); ++i) out << parts[i];
  if (result.surface) out << surface_section(*result.surface);
  out << engine_section(result) << setups_section(result) << tools_section(result)
      << inputs_section(result) << decision_section(result.surface.has_value())
      << assumptions_section(result.assumptions)
      << "</main>\n<footer><p>All lengths in mm or µm as stated. The same figures, digit for "
         "digit, are in "
         "result.json beside this page.</p></footer>\n</div>\n";
  out << parts.back() << "</body></html>\n";
}

}  // namespace limitgauge::reports
