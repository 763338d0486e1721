#include <fmt/format.h>

#include "model/text/number_text.h"
#include "reports/html/markup.h"
#include "reports/study/figure_column.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

using study::Method;

constexpr std::size_t kMostValues = 40;

std::string figure_label(const StudyView& view, const std::string& id) {
  const std::optional<std::size_t> figure = figure_index(view.table, id);
  return escape_markup(figure ? view.table.figures[*figure].label : id);
}

std::string method_sentence(const StudyView& view) {
  const study::Plan& plan = view.plan;
  switch (plan.method) {
    case Method::grid:
      return "Grid: every combination of the values below.";
    case Method::list:
      return "List: the combinations that the study file states.";
    case Method::random:
      return fmt::format("Random: {} settings drawn independently, seed {}.", grouped(plan.samples),
                         plan.seed);
    case Method::latin_hypercube:
      return fmt::format(
          "Latin hypercube: {} settings, each key's range cut into as many parts with one setting "
          "in each, seed {}.",
          grouped(plan.samples), plan.seed);
    case Method::one_at_a_time:
      return "One at a time: each key over its values, all others as in the reference case.";
    case Method::search:
      break;
  }
  return fmt::format(
      "Search: the least {} at which every gate passes, in at most {} cases, each key to {} % of "
      "its range.",
      figure_label(view, plan.search.cost), grouped(plan.search.most_cases),
      model::shortest(100 * plan.search.accuracy));
}

std::string values(const study::Variable& variable) {
  std::string out;
  for (std::size_t i = 0; i < std::min(variable.values.size(), kMostValues); ++i)
    out += (i == 0 ? "" : ", ") + escape_markup(setting_text(variable.values[i]));
  if (variable.values.size() > kMostValues)
    out += fmt::format(" and {} more", variable.values.size() - kMostValues);
  if (const auto& range = variable.range) {
    out += fmt::format("{}from {} to {}", out.empty() ? "" : "; ",
                       html::typeset(model::shortest(range->low)),
                       html::typeset(model::shortest(range->high)));
    if (range->steps > 0) out += fmt::format(" in {} steps", range->steps);
    if (range->logarithmic) out += ", evenly by their logarithms";
  }
  return out.empty() ? "–" : out;
}

}  // namespace

std::string design_section(const StudyView& view) {
  std::vector<std::vector<std::string>> lines;
  for (std::size_t i = 0; i < view.plan.variables.size(); ++i) {
    const study::Variable& variable = view.plan.variables[i];
    lines.push_back({escape_markup(variable.key), values(variable)});
    if (!view.about.own.empty())
      lines.back().push_back(
          i < view.about.own.size() ? escape_markup(setting_text(view.about.own[i])) : "–");
  }
  std::vector<html::Column> columns = {{"Key", false}, {"Values", false}};
  if (!view.about.own.empty()) columns.push_back({"in the job", false});
  std::string sentences = method_sentence(view);
  if (!view.analysis.search_ending.empty())
    sentences += " " + escape_markup(view.analysis.search_ending);
  return "<section id=\"design\"><h2>What was varied</h2>\n<p>" + sentences + "</p>\n" +
         html::table("Keys of the job, as --set takes them", columns, lines) + "</section>\n";
}

}  // namespace limitgauge::reports::study_report
