#pragma once

#include <string>
#include <vector>

#include "model/part/tolerances.h"
#include "verifier/robust/tolerance_box.h"

/// What is not known of tools and zero, in words that are markup already.
namespace limitgauge::reports::html {

/// All figures with a tolerance, under the names that they have in a result, those of tools that a
/// stage does not use among them.
std::vector<verifier::Tolerance> stated_tolerances(const model::Tolerances& tolerances);

/// "±5 µm", "−5 to +10 µm", "0 to +10 µm".
std::string range_words(const model::Interval& range_mm);
/// "+10 µm", "−5 µm", "0".
std::string offset_words(double mm);
/// "zero ±5 µm an axis; ball3: radius ±10 µm, length ±5 µm".
std::string tolerances_words(const model::Tolerances& tolerances);

}  // namespace limitgauge::reports::html
