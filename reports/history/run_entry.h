#pragma once

#include "history/entry.h"
#include "reports/record/run_record.h"

namespace limitgauge::reports::history_report {

/// What the names of tolerances begin with among the figures of a whole run.
inline constexpr const char* kToleranceMetric = "tolerance.";

/// What a history keeps of a run: every figure of each stage that was run, its gate's limits
/// (`gouge_limit_mm`, `uncut_limit_mm` or, where it judges figures over tolerances,
/// `robust_gouge_limit_mm`, `robust_uncut_limit_mm`; `coverage_limit`,
/// `unavoidable_uncut_limit_mm`, `unreachable_limit` or `unreachable_area_limit_mm2`), how finely
/// it was measured
/// (`resolution_mm`, `voxel_mm`), the machining time and the tolerances
/// (`tolerance.zero.x`, ...) of the whole run, and the verdicts. Commit and label are the caller's.
history::Entry entry_of(const record::RunRecord& run);

}  // namespace limitgauge::reports::history_report
