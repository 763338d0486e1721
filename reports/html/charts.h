#pragma once

#include <cstddef>
#include <string>

#include "reports/picture/deviation_scale.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports::html {

/// A certified interval as a bar on a track from zero, with the limit as a line.
std::string interval_chart(const verifier::Interval& interval_mm, bool has_limit, double limit_mm);

/// The area-weighted histogram with gate limits and zero marked; a limit that lies far beyond what
/// was measured is named at the side where it lies.
std::string histogram_chart(const verifier::StageDeviation& deviation,
                            const verifier::GateLimits& limits, std::size_t stage);

/// The colours of a map, from full scale of gouge (left) to full scale of uncut (right), in words
/// and numbers.
std::string colour_legend(const DeviationScale& scale);

}  // namespace limitgauge::reports::html
