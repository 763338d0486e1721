#pragma once

#include <string>
#include <vector>

#include "reports/run_result.h"

namespace limitgauge::reports {

/// How one figure of a stage stands against its limit.
enum class Standing {
  within,     ///< proven inside the limit
  beyond,     ///< proven outside
  undecided,  ///< the certified interval holds the limit
  no_limit,   ///< measured, not gated
  not_run,
};

/// One figure of the gate: what JUnit, the page and the terminal show of it.
struct GateFigure {
  std::string name;  ///< "gouge", "uncut", "coverage", "rapid collisions", "holder
                     ///< collisions", "process faults" (all others)
  Standing standing = Standing::not_run;
  std::string measured;  ///< "[0.076, 0.41] µm"; empty when the stage was not run
  std::string limit;     ///< "10 µm"; empty where there is none
};

/// The six figures of `stage`, always in the order above.
std::vector<GateFigure> gate_figures(const StageResult& stage);
/// Where a certified interval stands against a limit.
Standing standing_of(const verifier::Interval& interval_mm, double limit_mm);
/// limit : interval width, the test accuracy ratio of the decision rule; infinite for width zero.
double accuracy_ratio(const verifier::Interval& interval_mm, double limit_mm);
const char* name(Standing standing);

/// Below this ratio of limit to interval a report warns.
inline constexpr double kLeastAccuracyRatio = 4;

}  // namespace limitgauge::reports
