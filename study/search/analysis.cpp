#include "study/search/analysis.h"

#include <algorithm>

#include "study/plan/reference.h"
#include "study/search/objectives.h"
#include "study/search/pareto.h"
#include "study/search/recommend.h"
#include "study/search/sensitivity.h"

namespace limitgauge::study {
namespace {

Front front_of(const Table& table, const std::vector<std::size_t>& figures) {
  Front front;
  for (const std::size_t figure : figures) front.objectives.push_back(table.figures[figure].id);
  std::vector<std::size_t> rows;
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    std::optional<std::vector<double>> point = figures_of(table.rows[i], figures);
    if (!point) continue;
    rows.push_back(i);
    points.push_back(std::move(*point));
  }
  for (const std::size_t i : pareto_front(points)) front.rows.push_back(rows[i]);
  return front;
}

std::vector<Front> fronts(const Table& table, const Objectives& objectives) {
  std::vector<Front> all;
  if (!objectives.cost) return all;
  std::vector<std::size_t> together = {*objectives.cost};
  for (const std::size_t accuracy : objectives.accuracy) {
    all.push_back(front_of(table, {*objectives.cost, accuracy}));
    together.push_back(accuracy);
  }
  if (objectives.accuracy.size() > 1) all.push_back(front_of(table, together));
  return all;
}

/// What responses are told of: all that is paid and bought, and how far it is from the gates.
std::vector<std::size_t> figures_to_explain(const Table& table, const Objectives& objectives) {
  std::vector<std::size_t> figures = objectives.accuracy;
  if (objectives.cost) figures.insert(figures.begin(), *objectives.cost);
  const std::optional<std::size_t> excess = figure_index(table, "gate_excess");
  if (excess && std::find(figures.begin(), figures.end(), *excess) == figures.end())
    figures.push_back(*excess);
  return figures;
}

}  // namespace

Analysis analyse(const Plan& plan, const Table& table) {
  const Objectives asked = objectives(plan, table);
  const std::vector<std::size_t> figures = figures_to_explain(table, asked);
  Analysis analysis;
  analysis.fronts = fronts(table, asked);
  analysis.own = own_row(plan, table);
  analysis.reference = reference_row(plan, table, cheapest_passing(table, asked));
  analysis.responses = responses(plan, table, figures, analysis.reference);
  analysis.rankings = rankings(analysis.responses, figures);
  analysis.bought_for_nothing = bought_for_nothing(table, asked);
  analysis.recommendation = recommend(table, asked, analysis);
  return analysis;
}

}  // namespace limitgauge::study
