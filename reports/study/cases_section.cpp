#include <fmt/format.h>

#include "reports/html/markup.h"
#include "reports/study/case_table.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
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
