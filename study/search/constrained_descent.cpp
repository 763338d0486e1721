#include <algorithm>
#include <exception>
#include <nlopt.hpp>

#include "study/search/descent_search.h"

namespace limitgauge::study {
namespace {

/// What NLopt's callbacks work on. It loses all exceptions but its own: others are kept here.
struct Descent {
  Trials& trials;
  Spot spot;                         ///< where it began; text stays as it is there
  std::vector<std::size_t> ordered;  ///< axes
  std::size_t most_rows;
  double cost_unit;
  std::exception_ptr thrown = nullptr;

  std::size_t row_at(const std::vector<double>& x) {
    if (trials.rows().size() >= most_rows) throw nlopt::forced_stop();
    Spot at = spot;
    for (std::size_t i = 0; i < ordered.size(); ++i) at[ordered[i]] = x[i];
    try {
      return trials.run(at);
    } catch (...) {
      thrown = std::current_exception();
      throw nlopt::forced_stop();
    }
  }
};

double cost_at(const std::vector<double>& x, std::vector<double>&, void* data) {
  auto& descent = *static_cast<Descent*>(data);
  return descent.trials.cost(descent.row_at(x)) / descent.cost_unit;
}

double excess_at(const std::vector<double>& x, std::vector<double>&, void* data) {
  constexpr double kMost = 10;  // a case without a result must not drown what the others say
  auto& descent = *static_cast<Descent*>(data);
  return std::min(descent.trials.excess(descent.row_at(x)), kMost);
}

Spot spot_of(const Trials& trials, std::size_t row) {
  Spot spot;
  for (std::size_t i = 0; i < trials.axes().size(); ++i)
    spot.push_back(
        trials.axes()[i].coordinate_of(trials.rows()[row].asked.settings[i]).value_or(0));
  return spot;
}

void minimise(Descent& descent) {
  constexpr double kFirstStep = 0.2;
  constexpr int kMostCalls = 2000;  // settings that were run already cost nothing, but come again
  nlopt::opt cobyla(nlopt::LN_COBYLA, static_cast<unsigned>(descent.ordered.size()));
  std::vector<double> x, finest;
  for (const std::size_t axis : descent.ordered) {
    x.push_back(descent.spot[axis]);
    finest.push_back(descent.trials.axes()[axis].finest() / 2);
  }
  cobyla.set_lower_bounds(0.0);
  cobyla.set_upper_bounds(1.0);
  cobyla.set_min_objective(cost_at, &descent);
  cobyla.add_inequality_constraint(excess_at, &descent, 0);
  cobyla.set_initial_step(kFirstStep);
  cobyla.set_xtol_abs(finest);
  cobyla.set_maxeval(kMostCalls);
  double least = 0;
  try {
    cobyla.optimize(x, least);
  } catch (const nlopt::forced_stop&) {
    // No case left for it, or what is rethrown below.
  } catch (const nlopt::roundoff_limited&) {
    // As near as it gets.
  } catch (const std::runtime_error&) {
    // It gives up; what it has run stands.
  }
  if (descent.thrown) std::rethrow_exception(descent.thrown);
}

}  // namespace

void constrained_descent(Trials& trials, std::size_t cases) {
  const std::size_t best = *trials.best();
  Descent descent{trials, spot_of(trials, best), {}, trials.rows().size() + cases, 1};
  for (std::size_t i = 0; i < trials.axes().size(); ++i)
    if (trials.axes()[i].ordered() && trials.axes()[i].finest() < 1) descent.ordered.push_back(i);
  if (descent.ordered.empty() || cases == 0) return;
  for (std::size_t i = 0; i < trials.rows().size(); ++i)
    descent.cost_unit = std::max(descent.cost_unit, trials.cost(i));
  minimise(descent);
}

}  // namespace limitgauge::study
