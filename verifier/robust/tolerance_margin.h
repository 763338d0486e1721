#pragma once

#include <functional>

#include "verifier/gate/deviation.h"

namespace limitgauge::verifier {

/// No box is tried that is larger than the stated one by more.
inline constexpr double kLargestFactor = 100;

/// Finds by what factor a box may grow: a figure that grows with it is `at_none` without a box,
/// `at_whole` in the whole one and `figure(factor)` else, none for a box that no cutter has.
/// `proven` and `refuted` differ by a thousandth, unless what lies between is decided neither way.
ToleranceMargin find_margin(const Interval& at_none, const Interval& at_whole, double limit_mm,
                            const std::function<std::optional<Interval>(double)>& figure);

}  // namespace limitgauge::verifier
