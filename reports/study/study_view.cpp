#include "reports/study/study_view.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "reports/text/embedded.h"
#include "study/plan/reference.h"

namespace limitgauge::reports::study_report {
namespace {

using study::Status;

void add(std::vector<std::size_t>& list, std::optional<std::size_t> figure) {
  if (figure && std::find(list.begin(), list.end(), *figure) == list.end()) list.push_back(*figure);
}

int place(Status status) {
  switch (status) {
    case Status::pass:
      return 0;
    case Status::indeterminate:
      return 1;
    case Status::fail:
      return 2;
    case Status::error:
      return 3;
    case Status::lost:
      break;
  }
  return 4;
}

std::string padded(std::size_t number) {
  const std::string digits = std::to_string(number);
  return digits.size() < 4 ? std::string(4 - digits.size(), '0') + digits : digits;
}

}  // namespace

std::string result_path(std::size_t case_index) {
  return "cases/" + padded(case_index / 100 * 100) + "/" + padded(case_index) + "/result.json";
}

const std::string& study_schema() {
  static const std::string text{embedded::study_schema()};
  return text;
}

std::size_t count(const study::Table& table, Status status) {
  return std::count_if(table.rows.begin(), table.rows.end(),
                       [&](const study::Row& row) { return row.status == status; });
}

std::vector<std::size_t> objectives(const StudyView& view) {
  std::vector<std::size_t> list;
  for (const study::Front& front : view.analysis.fronts)
    for (const std::string& id : front.objectives) add(list, figure_index(view.table, id));
  if (!list.empty()) return list;
  const study::Objectives named = study::objectives(view.plan, view.table);
  add(list, named.cost);
  for (const std::size_t figure : named.accuracy) add(list, figure);
  return list;
}

std::optional<std::size_t> own_row(const StudyView& view) {
  if (view.analysis.own) return view.analysis.own;
  if (view.about.own.empty()) return std::nullopt;
  return study::row_with(view.table, view.about.own);
}

std::vector<std::size_t> best_rows(const StudyView& view, std::size_t most) {
  const std::vector<study::Row>& rows = view.table.rows;
  const std::vector<std::size_t> figures = objectives(view);
  const auto rank = [&](std::size_t i) {
    std::optional<double> cost;
    if (!figures.empty()) cost = rows[i].figures.at(figures.front());
    if (cost) cost = to_be_small(view.table.figures[figures.front()], *cost);
    return std::tuple(place(rows[i].status), cost.value_or(std::numeric_limits<double>::infinity()),
                      i);
  };
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  const std::size_t kept = std::min(most, order.size());
  std::partial_sort(order.begin(), order.begin() + kept, order.end(),
                    [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  order.resize(kept);
  return order;
}

}  // namespace limitgauge::reports::study_report
