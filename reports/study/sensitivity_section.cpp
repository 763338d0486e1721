#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/markup.h"
#include "reports/study/figure_column.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

struct Ends {
  double least = 0, most = 0;
};

Ends ends(const study::Response& response) {
  std::vector<double> values;
  for (const auto& point : response.points) values.push_back(point.value);
  for (const auto& point : response.fit) values.push_back(point.value);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

bool is_known(const study::Response& response) {
  return !response.points.empty() || !response.fit.empty();
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
  if (response.points.empty())
    return html::typeset(three_digits(response.fit.front().setting)) + " … " +
           html::typeset(three_digits(response.fit.back().setting));
  const auto text = [&](const study::Response::Point& point) {
    const study::Row& row = view.table.rows.at(point.row);
    return escape_markup(setting_text(row.asked.settings.at(response.key)));
  };
  return text(response.points.front()) + " … " + text(response.points.back());
}

std::vector<std::string> line(const StudyView& view, const study::Response& response) {
  const FigureColumn shown(view.table, response.figure);
  const Ends e = ends(response);
  return {escape_markup(view.table.keys.at(response.key)),
          between(view, response),
          shown.value(e.least) + " … " + shown.value(e.most),
          fmt::format("{}<span>{} %</span>", bar(strength(response)),
                      fixed(100 * strength(response), 0)),
          response.variance_share ? fixed(100 * *response.variance_share, 0) + " %" : "–",
          response.has_elasticity ? html::typeset(fixed(response.elasticity, 2)) : "–"};
}

std::string table_of(const StudyView& view, std::size_t figure) {
  std::vector<const study::Response*> list;
  for (const study::Response& response : view.analysis.responses)
    if (response.figure == figure && is_known(response)) list.push_back(&response);
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
                      {"of the variance", true},
                      {"elasticity", true}},
                     lines);
}

std::string how(const StudyView& view) {
  const auto& responses = view.analysis.responses;
  if (std::none_of(responses.begin(), responses.end(), is_known))
    return "There are too few finished cases to tell.";
  if (std::all_of(responses.begin(), responses.end(),
                  [](const study::Response& r) { return r.points.empty(); }))
    return "How far a figure moves over the range of one key, fitted by least squares through all "
           "cases; the strongest key first.";
  std::string out = "How far a figure moves when one key alone is varied, all others kept as in ";
  if (view.analysis.reference)
    out += fmt::format("case {}", view.table.rows.at(*view.analysis.reference).asked.index);
  else
    out += "the reference case";
  return out + "; the strongest key first.";
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
  tables = "<p>" + how(view) + "</p>\n" + tables;
  return "<section id=\"sensitivity\"><h2>What each key does</h2>\n" + tables + others +
         "</section>\n";
}

}  // namespace limitgauge::reports::study_report
