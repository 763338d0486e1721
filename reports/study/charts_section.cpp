#include "reports/study/parts.h"

namespace limitgauge::reports::study_report {

std::string charts_section(const StudyView&) {
  return "<section id=\"charts\"><h2>Charts</h2>\n<noscript><p class=\"note\">The charts need a "
         "script, which is switched off here. The tables below hold what they "
         "show.</p></noscript>\n<div data-study=\"\"></div></section>\n";
}

}  // namespace limitgauge::reports::study_report
