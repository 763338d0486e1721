#pragma once

#include <optional>
#include <string>

#include "study/search/trials.h"

namespace limitgauge::study {

/// How a search of one kind came to its end.
struct SearchEnd {
  SearchEnding how = SearchEnding::converged;
  std::string reason;  ///< a whole sentence
};

/// Of one ordered axis. Takes for granted that settings get cheaper in one direction and that, from
/// some setting on, none passes. Nothing where the rows at hand do not tell the direction; throws
/// what Trials::run throws.
std::optional<SearchEnd> section_search(Trials& trials, std::size_t batch);

/// Of a search for the largest setting: the two that bound it, as a whole sentence. What lies
/// between them cannot be decided, or is nearer to them than the accuracy.
std::string proven_bounds(const Trials& trials);

/// What of that the rows contradict, as a whole sentence; empty where nothing does.
std::string contradiction(const Trials& trials);

}  // namespace limitgauge::study
