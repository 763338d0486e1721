#pragma once

#include <optional>
#include <vector>

#include "study/search/analysis.h"
#include "study/search/objectives.h"

namespace limitgauge::study {

/// The passing row of the least cost, the first of several.
std::optional<std::size_t> cheapest_passing(const Table& table, const Objectives& objectives);

/// Passing rows that cost more than a passing one which no accuracy of theirs beats.
std::vector<BoughtForNothing> bought_for_nothing(const Table& table, const Objectives& objectives);

/// The cheapest passing row with its reasons; where nothing passes, what comes nearest.
Recommendation recommend(const Table& table, const Objectives& objectives,
                         const Analysis& analysis);

}  // namespace limitgauge::study
