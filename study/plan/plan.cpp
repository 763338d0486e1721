#include "study/plan/plan.h"

#include <algorithm>
#include <limits>

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

}  // namespace

const char* name(Method method) {
  switch (method) {
    case Method::grid:
      return "grid";
    case Method::list:
      return "list";
    case Method::random:
      return "random";
    case Method::latin_hypercube:
      return "latin_hypercube";
    case Method::one_at_a_time:
      return "one_at_a_time";
    case Method::search:
      break;
  }
  return "search";
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
