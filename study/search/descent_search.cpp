#include "study/search/descent_search.h"

#include <algorithm>
#include <cmath>

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
  return {passes ? SearchResult::Ending::converged : SearchResult::Ending::nothing_passes, reason};
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

}  // namespace limitgauge::study
