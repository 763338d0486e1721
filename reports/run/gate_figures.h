#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/run/run_result.h"
#include "reports/text/interval_text.h"

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
  /// "gouge", "uncut", "coverage", "unreachable", "unavoidable uncut", "missing stock", "rapid
  /// collisions", "holder collisions", "process faults" (all others). Where tolerances are stated,
  /// gouge and uncut are those over all their values, and "gouge as stated", "uncut as stated"
  /// those without.
  std::string name;
  Standing standing = Standing::not_run;
  std::string measured;       ///< "[0.076, 0.41] µm"; empty when the stage was not run
  std::string limit;          ///< "10 µm"; empty where there is none
  const char* relation = "";  ///< how `limit` is meant: "≤ ", "≥ "
  /// Of a certified length, for columns that stand in one unit.
  struct Length {
    verifier::Interval interval_mm;
    std::optional<double> limit_mm;
  };
  std::optional<Length> length = std::nullopt;

  /// As `measured` and `limit`, of a certified length in `unit` and without it; as they are of all
  /// else.
  std::string measured_in(const LengthUnit& unit) const;
  std::string limit_in(const LengthUnit& unit) const;
};

/// The unit in which the certified lengths of a column stand beside each other; `figures` may hold
/// others, too.
LengthUnit column_unit(const std::vector<GateFigure>& figures);

/// The figures of `stage` in the order above. Unavoidable uncut is there where it is gated or
/// something is out of reach, missing stock where some may be missing; the others always. Of a run
/// without a design the last three alone.
std::vector<GateFigure> gate_figures(const StageResult& stage);
/// What has to be said of a stage beside its verdict, whatever that is: "unreachable 12.3 mm²
/// (4.10 %), unavoidable uncut up to 0.3 mm"; "missing stock [0.5, 0.51] mm". None where all is in
/// reach and nothing missing. That a path has no moves, or in a run without a design that nothing
/// was cut.
std::vector<std::string> stage_notes(const StageResult& stage);
/// Whether a reason of the gate says again what `stage_notes` says.
bool is_note(const std::string& reason);
/// Where a certified interval stands against a limit.
Standing standing_of(const verifier::Interval& interval_mm, double limit_mm);
/// limit : interval width, the test accuracy ratio of the decision rule; infinite for width zero.
double accuracy_ratio(const verifier::Interval& interval_mm, double limit_mm);
const char* name(Standing standing);

/// Below this ratio of limit to interval a report warns.
inline constexpr double kLeastAccuracyRatio = 4;

}  // namespace limitgauge::reports
