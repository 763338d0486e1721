#include "study/search/analysis.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "study/plan/reference.h"
#include "study/search/objectives.h"

namespace limitgauge::study {
namespace {

using Point = std::vector<double>;

/// What was found so far, asked for points in rising order: none of them can dominate an earlier,
/// and the first coordinate of an earlier one never stands in the way.
class Found {
 public:
  explicit Found(std::size_t dimension) : others_(dimension > 0 ? dimension - 1 : 0) {}

  bool dominates(const Point& point) const {
    if (count_ == 0 || others_ == 0) return count_ > 0;
    // Of two coordinates the last kept has the least second one.
    if (others_ == 1) return kept_.back() <= point[1];
    return others_ == 2 ? is_over_stairs(point) : is_over_one(point);
  }

  void keep(const Point& point) {
    ++count_;
    kept_.insert(kept_.end(), point.begin() + 1, point.end());
    if (others_ != 2) return;
    auto step = stairs_.insert_or_assign(point[1], point[2]).first;
    for (++step; step != stairs_.end() && step->second >= point[2];) step = stairs_.erase(step);
  }

 private:
  bool is_over_stairs(const Point& point) const {
    const auto beyond = stairs_.upper_bound(point[1]);
    return beyond != stairs_.begin() && std::prev(beyond)->second <= point[2];
  }

  /// One after the other in memory: for ten thousand on the front this is what takes the time.
  bool is_over_one(const Point& point) const {
    const double* mine = point.data() + 1;
    for (const double* kept = kept_.data() + kept_.size(); kept != kept_.data();) {
      kept -= others_;
      bool at_most = true;
      for (std::size_t i = 0; i < others_ && at_most; ++i) at_most = kept[i] <= mine[i];
      if (at_most) return true;
    }
    return false;
  }

  std::size_t others_, count_ = 0;
  std::vector<double> kept_;  ///< all coordinates but the first
  /// Of three coordinates: the second with the least third up to there, which falls along it.
  std::map<double, double> stairs_;
};

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  std::vector<std::size_t> front;
  Found found(points.empty() ? 0 : points.front().size());
  for (const std::size_t i : order) {
    const bool alike = !front.empty() && points[front.back()] == points[i];
    if (!alike && found.dominates(points[i])) continue;
    if (!alike) found.keep(points[i]);
    front.push_back(i);
  }
  return front;
}

namespace {

Front front_of(const Table& table, const std::vector<std::size_t>& figures) {
  Front front;
  for (const std::size_t figure : figures) front.objectives.push_back(table.figures[figure].id);
  std::vector<std::size_t> rows;
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    std::optional<std::vector<double>> point = to_be_small(table, table.rows[i], figures);
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
