#include <fmt/format.h>

#include <algorithm>

#include "reports/html/markup.h"
#include "reports/study/case_table.h"
#include "reports/study/figure_column.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

constexpr std::size_t kMostFrontRows = 40;

/// At most kMostFrontRows of a list, evenly spread, both ends among them.
std::vector<std::size_t> spread(const std::vector<std::size_t>& rows) {
  if (rows.size() <= kMostFrontRows) return rows;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < kMostFrontRows; ++i)
    out.push_back(rows[i * (rows.size() - 1) / (kMostFrontRows - 1)]);
  return out;
}

std::string settings_words(const StudyView& view, std::size_t row) {
  std::string out;
  for (const study::Setting& setting : view.table.rows.at(row).asked.settings)
    out += (out.empty() ? "" : " · ") + escape_markup(setting_text(setting));
  return out;
}

std::string caption(const StudyView& view, const study::Front& front) {
  std::string out;
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const std::optional<std::size_t> figure = figure_index(view.table, front.objectives[i]);
    const std::string& name = figure ? view.table.figures[*figure].label : front.objectives[i];
    out += (i == 0 ? "" : i == 1 ? " against " : " and ") + escape_markup(name);
  }
  const std::size_t all = front.rows.size();
  out += fmt::format(": {} case{} that no other one beats", all, all == 1 ? "" : "s");
  if (all > kMostFrontRows)
    out += fmt::format("; {} of them evenly spread, all are in study.json", kMostFrontRows);
  return out;
}

std::string front_table(const StudyView& view, const study::Front& front) {
  std::vector<std::size_t> figures;
  for (const std::string& id : front.objectives)
    if (const auto figure = figure_index(view.table, id)) figures.push_back(*figure);
  return case_table(view, caption(view, front), spread(front.rows), figures);
}

/// Cases whose time buys nothing, and which one gives as much for less.
std::string bought_for_nothing(const StudyView& view) {
  const auto& list = view.analysis.bought_for_nothing;
  const std::vector<std::size_t> figures = objectives(view);
  if (list.empty() || figures.empty()) return {};
  const FigureColumn cost(view.table, figures.front());
  std::vector<std::vector<std::string>> lines;
  for (std::size_t i = 0; i < std::min(list.size(), kMostFrontRows); ++i)
    lines.push_back({case_link(view, list[i].row), settings_words(view, list[i].row),
                     case_link(view, list[i].by), settings_words(view, list[i].by),
                     cost.value(list[i].dearer)});
  std::string caption = fmt::format("{} case{} that pass, and what gives as much for less",
                                    grouped(list.size()), list.size() == 1 ? "" : "s");
  if (list.size() > kMostFrontRows)
    caption += fmt::format("; the first {} of them, all are in study.json", kMostFrontRows);
  const std::vector<html::Column> columns = {{"Case", true},
                                             {"Settings", false},
                                             {"better: case", true},
                                             {"its settings", false},
                                             {"saves", true}};
  return "<details><summary>Bought for nothing</summary>\n" + html::table(caption, columns, lines) +
         "</details>\n";
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
    // A front of three figures is long, and the other two say most of it.
    out += front.objectives.size() > 2
               ? "<details><summary>The front of all figures together</summary>\n" +
                     front_table(view, front) + "</details>\n"
               : front_table(view, front);
  }
  if (!any)
    out =
        "<section id=\"fronts\"><h2>What accuracy costs</h2>\n<p>No case passed or failed with "
        "figures that could be set against each other.</p>\n";
  return out + bought_for_nothing(view) + "</section>\n";
}

}  // namespace limitgauge::reports::study_report
