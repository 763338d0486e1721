#include "reports/study/case_table.h"

#include <fmt/format.h>

#include "reports/html/markup.h"
#include "reports/study/figure_column.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

bool all_numbers(const StudyView& view, std::size_t key) {
  for (const study::Row& row : view.table.rows)
    if (!row.asked.settings.at(key).number) return false;
  return true;
}

std::vector<html::Column> columns(const StudyView& view, const std::vector<FigureColumn>& figures) {
  std::vector<html::Column> list = {{"Case", true}, {"Verdict", false}};
  for (std::size_t i = 0; i < view.table.keys.size(); ++i)
    list.push_back({escape_markup(view.table.keys[i]), all_numbers(view, i)});
  for (const FigureColumn& figure : figures) list.push_back({escape_markup(figure.title()), true});
  return list;
}

/// What a case is beside its number: "recommended", "the job's own".
std::string marks(const StudyView& view, std::size_t row) {
  std::string out;
  if (view.analysis.recommendation.row == row) out += "<small>recommended</small>";
  if (own_row(view) == row) out += "<small>the job’s own</small>";
  return out;
}

}  // namespace

std::string case_link(const StudyView& view, std::size_t row) {
  const study::Row& what = view.table.rows.at(row);
  const std::size_t number = what.asked.index;
  if (!has_result(what)) return std::to_string(number);
  return fmt::format("<a href=\"{}\">{}</a>", result_path(number), number);
}

std::string case_table(const StudyView& view, const std::string& caption,
                       std::span<const std::size_t> rows, std::span<const std::size_t> figures) {
  std::vector<FigureColumn> shown;
  for (const std::size_t i : figures) shown.emplace_back(view.table, i);
  std::vector<html::Row> lines;
  for (const std::size_t i : rows) {
    const study::Row& row = view.table.rows.at(i);
    html::Row line;
    line.cells.push_back(case_link(view, i));
    line.cells.push_back(badge(row.status) + marks(view, i));
    for (const study::Setting& setting : row.asked.settings)
      line.cells.push_back(escape_markup(setting_text(setting)));
    for (std::size_t k = 0; k < shown.size(); ++k)
      line.cells.push_back(shown[k].cell(row.figures.at(figures[k])));
    lines.push_back(std::move(line));
  }
  return html::table(caption, columns(view, shown), lines);
}

}  // namespace limitgauge::reports::study_report
