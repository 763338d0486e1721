#pragma once

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// Findings of gouges, of leftovers and of the process into `out`: matched by place within
/// `reach_mm`, or within half the diagonal of the larger one's box.
void compare_findings(const record::StageRecord& base, const record::StageRecord& now,
                      double reach_mm, const Options& options, StageComparison& out);

}  // namespace limitgauge::reports::compare
