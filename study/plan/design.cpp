#include "study/plan/design.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "study/plan/sampling.h"
#include "study/plan/settings.h"

namespace limitgauge::study {
namespace {

std::size_t product(std::size_t a, std::size_t b) {
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  return b != 0 && a > kMost / b ? kMost : a * b;
}

std::size_t count_beside_base(const Variable& variable) {
  const std::size_t count = setting_count(variable);
  if (!variable.base || count > kMostCases) return count;
  const std::vector<Setting> all = settings_of(variable);
  return count - static_cast<std::size_t>(std::count(all.begin(), all.end(), *variable.base));
}

using Rows = std::vector<std::vector<Setting>>;

/// The last variable changes fastest.
Rows grid(const Plan& plan) {
  Rows rows(1);
  for (const Variable& variable : plan.variables) {
    const std::vector<Setting> settings = settings_of(variable);
    Rows longer;
    longer.reserve(rows.size() * settings.size());
    for (const std::vector<Setting>& row : rows) {
      for (const Setting& setting : settings) {
        longer.push_back(row);
        longer.back().push_back(setting);
      }
    }
    rows = std::move(longer);
  }
  return rows;
}

/// The base first, then each variable through its settings, the others at their base.
Rows one_at_a_time(const Plan& plan) {
  Rows rows(1);
  for (const Variable& variable : plan.variables) {
    if (!variable.base) throw std::invalid_argument("no base of " + variable.key);
    rows.front().push_back(*variable.base);
  }
  for (std::size_t v = 0; v < plan.variables.size(); ++v) {
    for (const Setting& setting : settings_of(plan.variables[v])) {
      if (setting == *plan.variables[v].base) continue;
      rows.push_back(rows.front());
      rows.back()[v] = setting;
    }
  }
  return rows;
}

Rows rows_of(const Plan& plan) {
  switch (plan.method) {
    case Method::grid:
      return grid(plan);
    case Method::list:
      return plan.listed;
    case Method::random:
      return random_samples(plan);
    case Method::latin_hypercube:
      return latin_hypercube_samples(plan);
    case Method::one_at_a_time:
      return one_at_a_time(plan);
    case Method::search:
      break;
  }
  throw std::invalid_argument("a search has no design");
}

}  // namespace

std::vector<Case> design(const Plan& plan) {
  const std::size_t count = case_count(plan);
  if (plan.variables.empty() || count == 0 || count > kMostCases)
    throw std::invalid_argument("a plan of " + std::to_string(count) + " cases");
  std::vector<Case> cases;
  for (std::vector<Setting>& settings : rows_of(plan))
    cases.push_back({cases.size(), std::move(settings)});
  return cases;
}

std::size_t case_count(const Plan& plan) {
  std::size_t count = 1;
  switch (plan.method) {
    case Method::grid:
      for (const Variable& variable : plan.variables)
        count = product(count, setting_count(variable));
      return count;
    case Method::list:
      return plan.listed.size();
    case Method::one_at_a_time:
      for (const Variable& variable : plan.variables) count += count_beside_base(variable);
      return count;
    case Method::search:
      return plan.search.most_cases;
    case Method::random:
    case Method::latin_hypercube:
      break;
  }
  return plan.samples;
}

}  // namespace limitgauge::study
