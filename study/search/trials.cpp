#include "study/search/trials.h"

#include <algorithm>

#include "study/search/objectives.h"

namespace limitgauge::study {
namespace {

std::string key_of(const std::vector<Setting>& settings) {
  std::string key;
  for (const Setting& setting : settings) key += setting.toml + '\0';
  return key;
}

std::optional<std::size_t> index_of(std::span<const Figure> figures, const std::string& id) {
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (figures[i].id == id) return i;
  return std::nullopt;
}

}  // namespace

Trials::Trials(const Plan& plan, std::span<const Figure> figures, const Evaluate& evaluate,
               const std::atomic<bool>* stop)
    : axes_(axes_of(plan)),
      evaluate_(&evaluate),
      stop_(stop),
      most_(plan.search.most_cases),
      seeks_largest_(plan.search.largest.has_value()),
      figures_(figures.begin(), figures.end()),
      cost_(index_of(figures, plan.search.cost)),
      excess_(index_of(figures, "gate_excess")) {}

std::vector<std::size_t> Trials::run(const std::vector<Spot>& spots) {
  std::vector<Case> asked;
  std::vector<std::size_t> places;
  bool all_fit = true;
  for (const Spot& spot : spots) {
    std::vector<Setting> settings = settings_at(axes_, spot);
    const std::string key = key_of(settings);
    const auto known = known_.find(key);
    if (known != known_.end()) {
      places.push_back(known->second);
    } else if (asked.size() < cases_left()) {
      const std::size_t index = rows_.size() + asked.size();
      known_.emplace(key, index);
      places.push_back(index);
      asked.push_back({index, std::move(settings)});
    } else {
      all_fit = false;
    }
  }
  if (!asked.empty()) {
    if (stop_ != nullptr && *stop_) throw OutOfCases{true};
    std::vector<Row> rows = (*evaluate_)(asked);
    const std::size_t given = std::min(rows.size(), asked.size());
    for (std::size_t i = 0; i < given; ++i) {
      rows[i].asked = asked[i];
      rows_.push_back(std::move(rows[i]));
      if (!best_ || better(rows_.size() - 1, *best_)) best_ = rows_.size() - 1;
    }
    if (given < asked.size()) throw OutOfCases{true};
  }
  if (!all_fit) throw OutOfCases{};
  return places;
}

std::optional<double> Trials::figure(std::size_t row,
                                     const std::optional<std::size_t>& index) const {
  return index ? figure_of(rows_[row], *index) : std::nullopt;
}

double Trials::excess(std::size_t row) const {
  constexpr double kWithoutResult = 1e3, kUnmeasured = 1;
  const std::optional<double> measured = figure(row, excess_);
  if (passes(row)) return std::min(measured.value_or(-kUnmeasured), 0.0);
  if (!has_result(rows_[row])) return kWithoutResult;
  return measured && *measured > 0 ? *measured : kUnmeasured;
}

bool Trials::is_whole(std::size_t row) const {
  if (!has_result(rows_[row]) || !figure(row, cost_)) return false;
  if (seeks_largest_) return true;
  for (std::size_t i = 0; i < figures_.size(); ++i)
    if (!figure(row, i) && !figures_[i].optional && excess_ != i) return false;
  return true;
}

double Trials::own_cost(std::size_t row) const {
  return to_be_small(figures_[*cost_], *figure(row, cost_));
}

double Trials::cost(std::size_t row) const {
  if (is_whole(row)) return own_cost(row);
  double most = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (is_whole(i)) most = std::max(most, own_cost(i));
  return most;
}

bool Trials::better(std::size_t a, std::size_t b) const {
  if (passes(a) != passes(b)) return passes(a);
  const double of_a = passes(a) ? cost(a) : excess(a), of_b = passes(a) ? cost(b) : excess(b);
  return of_a != of_b ? of_a < of_b : a < b;
}

}  // namespace limitgauge::study
