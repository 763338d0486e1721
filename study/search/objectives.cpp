#include "study/search/objectives.h"

namespace limitgauge::study {
namespace {

/// Of the last stage that has it.
void add_last(const Table& table, std::string_view end, std::vector<std::size_t>& to) {
  for (std::size_t i = table.figures.size(); i-- > 0;) {
    if (!table.figures[i].id.ends_with(end)) continue;
    to.push_back(i);
    return;
  }
}

}  // namespace

Objectives objectives(const Plan& plan, const Table& table) {
  Objectives found;
  found.cost = figure_index(table, plan.cost);
  for (const std::string& id : plan.accuracy)
    if (const std::optional<std::size_t> index = figure_index(table, id))
      found.accuracy.push_back(*index);
  if (!plan.accuracy.empty()) return found;
  add_last(table, ".uncut_mm.high", found.accuracy);
  add_last(table, ".gouge_mm.high", found.accuracy);
  return found;
}

std::optional<std::size_t> figure_index(const Table& table, const std::string& id) {
  for (std::size_t i = 0; i < table.figures.size(); ++i)
    if (table.figures[i].id == id) return i;
  return std::nullopt;
}

std::optional<double> figure_of(const Row& row, std::size_t figure) {
  return figure < row.figures.size() ? row.figures[figure] : std::nullopt;
}

double to_be_small(const Figure& figure, double value) {
  return figure.larger_is_better ? -value : value;
}

bool has_result(const Row& row) {
  return row.status == Status::pass || row.status == Status::fail ||
         row.status == Status::indeterminate;
}

std::optional<std::vector<double>> figures_of(const Row& row,
                                              const std::vector<std::size_t>& figures) {
  if (!has_result(row)) return std::nullopt;
  std::vector<double> values;
  for (const std::size_t figure : figures) {
    const std::optional<double> value = figure_of(row, figure);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<std::vector<double>> to_be_small(const Table& table, const Row& row,
                                               const std::vector<std::size_t>& figures) {
  std::optional<std::vector<double>> values = figures_of(row, figures);
  for (std::size_t i = 0; values && i < figures.size(); ++i)
    (*values)[i] = to_be_small(table.figures[figures[i]], (*values)[i]);
  return values;
}

}  // namespace limitgauge::study
