#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/markup.h"
#include "reports/study/parts.h"
#include "reports/study/shown.h"
#include "reports/text.h"

namespace limitgauge::reports::study_report {
namespace {

struct Ends {
  double least = 0, most = 0;
};

Ends ends(const study::Response& response) {
  const auto [least, most] =
      std::minmax_element(response.points.begin(), response.points.end(),
                          [](const auto& a, const auto& b) { return a.value < b.value; });
  return {least->value, most->value};
}

/// Change by the largest value: 0 where the key does nothing, 1 where it decides all.
double strength(const study::Response& response) {
  const Ends e = ends(response);
  const double size = std::max(std::abs(e.least), std::abs(e.most));
  return size > 0 ? (e.most - e.least) / size : 0;
}

std::string bar(double share) {
  return fmt::format(
      "<svg class=\"study-bar\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\"><rect class=\"track\" width=\"100\" height=\"10\"/>"
      "<rect class=\"inside\" width=\"{}\" height=\"10\"/></svg>",
      fixed(100 * std::clamp(share, 0.0, 1.0), 1));
}

std::string between(const StudyView& view, const study::Response& response) {
  const auto text = [&](std::size_t point) {
    const study::Row& row = view.table.rows.at(response.points[point].row);
    return escape_markup(setting_text(row.asked.settings.at(response.key)));
  };
  return text(0) + " … " + text(response.points.size() - 1);
}

std::vector<std::string> line(const StudyView& view, const study::Response& response) {
  const ShownFigure shown(view.table, response.figure);
  const Ends e = ends(response);
  return {escape_markup(view.table.keys.at(response.key)), between(view, response),
          shown.value(e.least) + " … " + shown.value(e.most),
          fmt::format("{}{} %", bar(strength(response)), fixed(100 * strength(response), 0)),
          response.has_elasticity ? html::typeset(fixed(response.elasticity, 2)) : "–"};
}

std::string table_of(const StudyView& view, std::size_t figure) {
  std::vector<const study::Response*> list;
  for (const study::Response& response : view.analysis.responses)
    if (response.figure == figure && !response.points.empty()) list.push_back(&response);
  if (list.empty()) return {};
  std::stable_sort(list.begin(), list.end(),
                   [](const auto* a, const auto* b) { return strength(*a) > strength(*b); });
  std::vector<std::vector<std::string>> lines;
  for (const study::Response* response : list) lines.push_back(line(view, *response));
  return html::table(escape_markup(view.table.figures[figure].label),
                     {{"Key", false},
                      {"tried", false},
                      {"least … most", true},
                      {"change, of the most", true},
                      {"elasticity", true}},
                     lines);
}

}  // namespace

std::string sensitivity_section(const StudyView& view) {
  std::string tables, others;
  const std::vector<std::size_t> first = objectives(view);
  for (const std::size_t figure : first) tables += table_of(view, figure);
  for (std::size_t figure = 0; figure < view.table.figures.size(); ++figure)
    if (std::find(first.begin(), first.end(), figure) == first.end())
      others += table_of(view, figure);
  if (!others.empty())
    others = "<details><summary>Other figures</summary>\n" + others + "</details>\n";
  if (tables.empty() && others.empty())
    tables = "<p>No two finished cases differ in one key alone.</p>\n";
  else
    tables =
        "<p>How far a figure moves when one key alone is varied, all others kept as they are "
        "in the reference case; the strongest key first.</p>\n" +
        tables;
  return "<section id=\"sensitivity\"><h2>What each key does</h2>\n" + tables + others +
         "</section>\n";
}

}  // namespace limitgauge::reports::study_report
