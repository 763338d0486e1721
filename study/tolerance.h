#pragma once

/// The study's tolerances: value, unit and reason of each.

namespace limitgauge::study {

/// Share of a cost, or of a range of settings, by which two that are alike may differ by rounding.
inline constexpr double kAlike = 1e-9;
/// Share of the largest figure below which a spread of figures is rounding: there is nothing to have
/// a share in.
inline constexpr double kNoSpread = 1e-12;
/// Share of the distance of two steps to which a step is rounded, so that it has few digits.
inline constexpr double kStepRounding = 1e-3;

}  // namespace limitgauge::study
