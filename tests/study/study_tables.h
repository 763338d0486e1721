#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/plan/design.h"
#include "study/plan/settings.h"

namespace limitgauge::study {

inline Variable listed(const std::string& key, const std::vector<double>& numbers) {
  Variable variable{key, {}, {}, {}};
  for (const double number : numbers) variable.values.push_back(number_setting(number));
  return variable;
}

inline Variable words(const std::string& key, const std::vector<std::string>& texts) {
  Variable variable{key, {}, {}, {}};
  for (const std::string& text : texts) variable.values.push_back({'"' + text + '"', {}});
  return variable;
}

inline Variable ranged(const std::string& key, const Range& range) {
  return {key, {}, range, {}};
}

inline Plan plan_of(Method method, std::vector<Variable> variables, std::size_t samples = 0,
                    std::uint64_t seed = 0) {
  Plan plan;
  plan.method = method;
  plan.variables = std::move(variables);
  plan.samples = samples;
  plan.seed = seed;
  return plan;
}

/// What a made-up job answers to its settings.
struct Answer {
  double cost, excess, uncut;
};
using Job = std::function<Answer(const std::vector<Setting>&)>;

inline std::vector<Figure> made_up_figures() {
  return {{"machining_time_s", "machining time", "s"},
          {"gate_excess", "largest excess over a limit", ""},
          {"finish.uncut_mm.high", "finish: uncut, certified", "mm"}};
}

inline Row row_of(const Case& asked, const Answer& answer) {
  Row row;
  row.asked = asked;
  row.status = answer.excess > 0 ? Status::fail : Status::pass;
  if (answer.excess > 0) row.reason = "finish: uncut beyond its limit";
  row.figures = {answer.cost, answer.excess, answer.uncut};
  return row;
}

inline Table table_of(const Plan& plan, const Job& job) {
  Table table;
  for (const Variable& variable : plan.variables) table.keys.push_back(variable.key);
  table.figures = made_up_figures();
  for (const Case& one : design(plan)) table.rows.push_back(row_of(one, job(one.settings)));
  return table;
}

}  // namespace limitgauge::study
