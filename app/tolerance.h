#pragma once

/// Tolerances in what a job may ask for: value, unit and reason of each.

namespace limitgauge::app {

/// A limit surface that is smaller is a point.
inline constexpr double kLeastExtentMm = 2e-3;
/// Of the extent, or its square: what is narrower has no area. At coordinates of 10 m points on one
/// line are off it by 2e-12 mm, which is this much of the least extent.
inline constexpr double kLeastShare = 1e-9;

}  // namespace limitgauge::app
