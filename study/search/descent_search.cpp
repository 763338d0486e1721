#include "study/search/descent_search.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include <nlopt.hpp>

#include "study/plan/design.h"
#include "study/plan/sampling.h"

namespace limitgauge::study {
namespace {

std::optional<Spot> spot_of(const std::vector<Axis>& axes, const std::vector<Setting>& settings) {
  Spot spot;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::optional<double> at = axes[i].coordinate_of(settings[i]);
    if (!at) return std::nullopt;
    spot.push_back(*at);
  }
  return spot;
}

/// The job's own settings, where they are among what may be chosen, and a Latin hypercube.
std::vector<Spot> first_spots(const Trials& trials, const Plan& plan) {
  Plan spread = plan;
  spread.method = Method::latin_hypercube;
  spread.samples = std::max(plan.search.batch, 2 * plan.variables.size() + 1);
  spread.samples = std::clamp<std::size_t>(plan.search.most_cases / 3, 1, spread.samples);
  std::vector<Spot> spots;
  std::vector<Setting> own;
  for (const Variable& variable : plan.variables)
    if (variable.base) own.push_back(*variable.base);
  if (own.size() == plan.variables.size())
    if (const std::optional<Spot> spot = spot_of(trials.axes(), own)) spots.push_back(*spot);
  for (const std::vector<Setting>& settings : latin_hypercube_samples(spread))
    if (const std::optional<Spot> spot = spot_of(trials.axes(), settings)) spots.push_back(*spot);
  return spots;
}

SearchEnd ended(const Trials& trials, const std::string& reason) {
  const bool passes = trials.best() && trials.passes(*trials.best());
  return {passes ? SearchEnding::converged : SearchEnding::nothing_passes, reason};
}

SearchEnd run_all(Trials& trials, const Plan& plan) {
  Plan all = plan;
  all.method = Method::grid;
  std::vector<Spot> spots;
  for (const Case& one : design(all)) spots.push_back(*spot_of(trials.axes(), one.settings));
  trials.run(spots);
  return ended(trials, "every combination was run.");
}

/// One step away along each axis and, where there are few of them, along two at once: on the border
/// of what passes, one setting can only give way where another takes its place.
std::vector<Spot> neighbours(const std::vector<Axis>& axes, const Spot& centre, double step) {
  std::vector<Spot> spots;
  std::vector<std::size_t> ordered;
  const auto moved = [&](Spot spot, std::size_t axis, double sign) {
    spot[axis] = std::clamp(spot[axis] + sign * std::max(step, axes[axis].finest()), 0.0, 1.0);
    return spot;
  };
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (!axes[a].ordered()) continue;
    ordered.push_back(a);
    for (const double sign : {1.0, -1.0}) spots.push_back(moved(centre, a, sign));
  }
  constexpr std::size_t kFew = 3;
  if (ordered.size() <= kFew)
    for (std::size_t i = 0; i < ordered.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const double a : {1.0, -1.0})
          for (const double b : {1.0, -1.0})
            spots.push_back(moved(moved(centre, ordered[i], a), ordered[j], b));
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (axes[a].ordered()) continue;
    for (std::size_t i = 0; i < axes[a].count(); ++i) {
      Spot other = centre;
      other[a] = static_cast<double>(i);
      if (other != centre) spots.push_back(std::move(other));
    }
  }
  return spots;
}

/// True as soon as some of `spots` are better than the best so far.
bool improved(Trials& trials, const std::vector<Spot>& spots, std::size_t batch) {
  const std::size_t before = *trials.best();
  for (std::size_t from = 0; from < spots.size(); from += batch) {
    const std::size_t to = std::min(spots.size(), from + batch);
    trials.run(std::vector<Spot>(spots.begin() + static_cast<std::ptrdiff_t>(from),
                                 spots.begin() + static_cast<std::ptrdiff_t>(to)));
    if (*trials.best() != before) return true;
  }
  return false;
}

double finest_of(const std::vector<Axis>& axes) {
  double finest = 1;
  for (const Axis& axis : axes)
    if (axis.ordered()) finest = std::min(finest, axis.finest());
  return finest;
}

SearchEnd pattern_search(Trials& trials, std::size_t batch) {
  constexpr double kFirstStep = 0.125;
  const std::vector<Axis>& axes = trials.axes();
  const double finest = finest_of(axes);
  for (double step = std::max(kFirstStep, finest);;) {
    const Spot centre = *spot_of(axes, trials.rows()[*trials.best()].asked.settings);
    if (improved(trials, neighbours(axes, centre, step), batch)) continue;
    if (step <= finest)
      return ended(trials, "no neighbour of the best setting is better, one accuracy away.");
    step = std::max(step / 2, finest);
  }
}

}  // namespace

SearchEnd descent_search(Trials& trials, const Plan& plan) {
  const std::optional<std::size_t> room = combinations(plan);
  if (room && *room <= plan.search.most_cases) return run_all(trials, plan);
  trials.run(first_spots(trials, plan));
  constrained_descent(trials, trials.cases_left() / 2);
  return pattern_search(trials, plan.search.batch);
}

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
