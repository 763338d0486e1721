#include <fmt/format.h>

#include "reports/html/markup.h"
#include "reports/study/case_table.h"
#include "reports/study/parts.h"
#include "reports/text.h"

namespace limitgauge::reports::study_report {
namespace {

constexpr std::size_t kMostRows = 100;

std::string caption(const StudyView& view, const study::Front& front) {
  std::string out;
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const std::optional<std::size_t> figure = figure_index(view.table, front.objectives[i]);
    const std::string& name = figure ? view.table.figures[*figure].label : front.objectives[i];
    out += (i == 0 ? "" : i == 1 ? " against " : " and ") + escape_markup(name);
  }
  const std::size_t all = front.rows.size();
  out += fmt::format(": {} case{} that no other one beats", all, all == 1 ? "" : "s");
  if (all > kMostRows)
    out += fmt::format("; the first {} of them, all are in study.json", kMostRows);
  return out;
}

std::string front_table(const StudyView& view, const study::Front& front) {
  std::vector<std::size_t> figures;
  for (const std::string& id : front.objectives)
    if (const auto figure = figure_index(view.table, id)) figures.push_back(*figure);
  const std::span<const std::size_t> rows(front.rows.data(),
                                          std::min(front.rows.size(), kMostRows));
  return case_table(view, caption(view, front), rows, figures, false);
}

}  // namespace

std::string fronts_section(const StudyView& view) {
  std::string out =
      "<section id=\"fronts\"><h2>What accuracy costs</h2>\n"
      "<p>From one line to the next, time buys accuracy; every case that is not here gives less "
      "for the same time, or takes longer for the same.</p>\n";
  bool any = false;
  for (const study::Front& front : view.analysis.fronts) {
    if (front.rows.empty()) continue;
    any = true;
    out += front_table(view, front);
  }
  if (!any)
    out =
        "<section id=\"fronts\"><h2>What accuracy costs</h2>\n<p>No case passed or failed with "
        "figures that could be set against each other.</p>\n";
  return out + "</section>\n";
}

}  // namespace limitgauge::reports::study_report
