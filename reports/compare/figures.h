#pragma once

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// Every metric of a stage that both runs measured.
std::vector<FigureChange> compare_figures(const record::StageMeasures& base,
                                          const record::StageMeasures& now, const Options& options);

}  // namespace limitgauge::reports::compare
