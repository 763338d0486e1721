#pragma once

/// The reports' tolerances: value, unit and reason of each. What counts as a change of a figure is
/// in compare/noise.cpp.

namespace limitgauge::reports {

/// Lengths that differ by less are one: a nanometre, far below the digits of a program and far
/// above rounding. An interval of no width would else call its last bit a change.
inline constexpr double kSameLength_mm = 1e-6;
/// A sample's length below half of that is rounding, and shown as none.
inline constexpr double kNoLength_mm = 5e-7;
/// The lower end of an interval of areas below this may be rounded down to none.
inline constexpr double kNoArea_mm2 = 1e-3;
/// Stands for a limit of zero where a figure is divided by its limit: any length is far beyond it.
inline constexpr double kZeroLimit_mm = 1e-9;
/// What is drawn to scale is taken to be at least this long, so that no scale divides by zero: far
/// below anything that is cut.
inline constexpr double kLeastExtent_mm = 1e-9;
/// The like of what an eye sees: length over distance, no unit.
inline constexpr double kLeastSeen = 1e-9;
/// Numbers that differ by less of their size, or of the axis that they stand on, differ by the
/// rounding of a few operations only, which is some 1e-16 each. No unit.
inline constexpr double kRounding = 1e-9;

}  // namespace limitgauge::reports
