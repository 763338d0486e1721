#include "study/search/search.h"

#include <stdexcept>

#include "study/search/descent_search.h"
#include "study/search/phrases.h"
#include "study/store/table.h"

namespace limitgauge::study {
namespace {

using Ending = SearchResult::Ending;

SearchEnd run_search(Trials& trials, const Plan& plan) {
  try {
    if (trials.axes().size() == 1 && trials.axes()[0].ordered())
      if (const std::optional<SearchEnd> end = section_search(trials, plan.search.batch))
        return *end;
    return descent_search(trials, plan);
  } catch (const OutOfCases& out) {
    if (out.stopped) return {Ending::stopped, "it was stopped."};
    return {Ending::budget, "no more cases may be run."};
  }
}

std::string told(const SearchResult& result, const std::string& reason, const Search& search) {
  const std::string after = " after " + counted(result.rows.size(), "case") + " of at most " +
                            std::to_string(search.most_cases);
  const char* how = result.how == Ending::converged ? "The search converged" : "The search ended";
  std::string text = how + after + ": " + reason;
  if (!result.best) text += " Nothing that was run passes every gate.";
  if (result.best && result.how != Ending::converged)
    text += search.largest
                ? " The answer is the largest that passed until then; there may be a larger one."
                : " The answer is the cheapest that passed until then; there may be a cheaper one.";
  return text;
}

}  // namespace

SearchResult search(const Plan& plan, std::span<const Figure> figures, const Evaluate& evaluate,
                    const std::atomic<bool>* stop) {
  if (plan.variables.empty() || plan.search.batch == 0 || plan.search.most_cases == 0)
    throw std::invalid_argument("a search of nothing");
  if (plan.search.largest && plan.variables.size() != 1)
    throw std::invalid_argument("the largest setting of several keys");
  Trials trials(plan, figures, evaluate, stop);
  const SearchEnd end = run_search(trials, plan);
  const std::string against = contradiction(trials);
  SearchResult result;
  result.how = end.how;
  result.contradicted = !against.empty();
  if (const std::optional<std::size_t> best = trials.best())
    if (trials.passes(*best)) result.best = best;
  const std::string bounds = plan.search.largest ? " " + proven_bounds(trials) : std::string();
  result.rows = trials.take_rows();
  result.ending = told(result, end.reason, plan.search) + bounds;
  if (!against.empty()) result.ending += " " + against;
  return result;
}

}  // namespace limitgauge::study
