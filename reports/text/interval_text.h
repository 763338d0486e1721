#pragma once

#include <optional>
#include <string>

#include "reports/text/text.h"
#include "verifier/gate/deviation.h"

/// Certified figures as people read them. What is printed never says more than what is proven, and
/// lies on the side of its limit on which the exact figure lies: where the digits that are usual
/// would hide that, more are printed.
namespace limitgauge::reports {

/// A certified interval without its unit, rounded outwards by no more than a fifth of its width:
/// "[0.44, 0.52]".
std::string interval_numbers(const verifier::Interval& interval_mm, const LengthUnit& unit,
                             const std::optional<double>& limit_mm = std::nullopt);
/// A stated length with all its digits and without its unit.
std::string stated_number(double mm, const LengthUnit& unit);
/// A measured length, three significant digits, without its unit; beside a limit likewise.
std::string measured_number(double mm, const LengthUnit& unit,
                            const std::optional<double>& limit_mm = std::nullopt);
/// The same in the unit that suits it, and with it.
std::string measured_beside(double mm, const std::optional<double>& limit_mm);
/// A share as a percentage, rounded down; beside the least that is accepted likewise.
std::string percent_beside(double share, double least);
/// A stated share with all its digits, two places at least: "99.00 %", "99.005 %".
std::string stated_percent(double share);

}  // namespace limitgauge::reports
