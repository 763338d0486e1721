#include <ostream>

#include <fmt/format.h>

#include "reports/html/markup.h"
#include "reports/html/shell.h"
#include "reports/study/case_table.h"
#include "reports/study/parts.h"
#include "reports/text/embedded.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

constexpr const char* kContents =
    "<nav class=\"contents\" aria-label=\"Contents\"><ul>"
    "<li><a href=\"#charts\">Charts</a></li><li><a href=\"#fronts\">What accuracy costs</a></li>"
    "<li><a href=\"#sensitivity\">What each key does</a></li><li><a href=\"#cases\">Cases</a></li>"
    "<li><a href=\"#reasons\">What did not pass</a></li>"
    "<li><a href=\"#design\">What was varied</a></li>"
    "<li><a href=\"#words\">How to read this</a></li></ul></nav>\n";

constexpr const char* kWords =
    "<section id=\"words\"><h2>How to read this</h2>\n<ul>"
    "<li><strong>passed</strong>: every gate figure of every stage is proven inside its limit; "
    "<strong>failed</strong>: one is proven beyond it; <strong>undecided</strong>: a certified "
    "interval still holds a limit at the finest resolution that the job allows.</li>"
    "<li><strong>error</strong>: the job cannot be run with these settings; "
    "<strong>lost</strong>: whoever ran the case died or did not answer, as often as it was "
    "tried.</li>"
    "<li>A case is on a front if no other case that passed or failed is at least as good in each "
    "of "
    "its figures and better in one. What fails is shown, too: it tells what a looser gate would "
    "buy.</li>"
    "<li>The elasticity of a figure is by how many per cent it rises when the key rises by one per "
    "cent, fitted over all the values that were tried.</li></ul></section>\n";

}  // namespace

void write_study_html(const study::Plan& plan, const study::Table& table,
                      const study::Analysis& analysis, std::ostream& out, const About& about) {
  const StudyView view{plan, table, analysis, about};
  const html::Script script{embedded::study_js(), embedded::study_js_sha256(),
                            embedded::study_css()};
  out << html::shell_head(table.name + ": study", script) << masthead(view) << kContents
      << "<main id=\"figures\" tabindex=\"-1\">\n"
      << charts_section(view) << fronts_section(view) << sensitivity_section(view)
      << cases_section(view) << reasons_section(view) << design_section(view) << kWords
      << "</main>\n<footer><p>All figures of all cases, digit for digit, are in study.csv and "
         "study.json beside this page; a case's whole result is in its folder below "
         "cases.</p></footer>\n"
      << html::shell_end(script, page_data(view));
}

std::string charts_section(const StudyView&) {
  return "<section id=\"charts\"><h2>Charts</h2>\n<noscript><p class=\"note\">The charts need a "
         "script, which is switched off here. The tables below hold what they "
         "show.</p></noscript>\n<div data-study=\"\"></div></section>\n";
}

namespace {

/// What a reader scrolls through; the script pages through all of them.
constexpr std::size_t kMostRows = 200;

}  // namespace

std::string cases_section(const StudyView& view) {
  const std::size_t all = view.table.rows.size();
  const std::vector<std::size_t> rows = best_rows(view, kMostRows);
  const std::string which = all > rows.size()
                                ? fmt::format("The first {} of {} cases; all are in study.csv.",
                                              rows.size(), grouped(all))
                                : fmt::format("All {} case{}.", all, all == 1 ? "" : "s");
  return fmt::format(
             "<section id=\"cases\"><h2>Cases</h2>\n<p>{} Those that passed come first, then "
             "undecided and failed ones, the cheapest at the head. A number leads to the case’s "
             "whole result.</p>\n<div data-cases=\"\"><div class=\"static\">",
             which) +
         case_table(view, "Settings and figures", rows, objectives(view)) +
         "</div></div></section>\n";
}

}  // namespace limitgauge::reports::study_report
