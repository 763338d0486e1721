#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/search/trials.h"

namespace limitgauge::study {

struct SearchResult {
  using Ending = SearchEnding;

  std::vector<Row> rows;            ///< all that were run, by Case::index; none twice
  std::optional<std::size_t> best;  ///< into `rows`: it was run, it passed, and no other is cheaper
  Ending how = Ending::stopped;
  /// Of one ordered variable: a setting passed beyond one that did not, or the cost went back.
  bool contradicted = false;
  std::string ending;  ///< how it ended, whole sentences
};

/// The cheapest setting at which every gate passes; where plan.search.largest is set, the largest,
/// with what is proven to fail beyond it. `figures` are those of the rows; of them the
/// search reads plan.search.cost and "gate_excess". The same plan and the same rows give the same
/// search, whatever runs them.
///
/// One variable that has an order: both ends and settings between them, then the stretch between
/// the last that passes and the first that does not is cut into plan.search.batch + 1 parts until
/// it is no wider than plan.search.accuracy. Several: a Latin hypercube to begin with, COBYLA
/// (Powell 1994) from the best of it with the excess as its constraint, then a pattern search that
/// also tries other texts and ends where no neighbour at the accuracy is better.
SearchResult search(const Plan& plan, std::span<const Figure> figures, const Evaluate& evaluate,
                    const std::atomic<bool>* stop = nullptr);

}  // namespace limitgauge::study
