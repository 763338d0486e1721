#pragma once

/// Tolerances in what a job may ask for: value, unit and reason of each.

namespace limitgauge::app {

/// A limit surface that is smaller is a point.
inline constexpr double kLeastExtentMm = 2e-3;
/// Of the extent, or its square: what is narrower has no area. At coordinates of 10 m points on one
/// line are off it by 2e-12 mm, which is this much of the least extent.
inline constexpr double kLeastShare = 1e-9;

/// Rates of a job, mm/min: at the least a day for a millimetre and a half, at the most 16 m/s,
/// eight times the rapids of the fastest machines.
inline constexpr double kLeastRate_mm_min = 1e-3;
inline constexpr double kLargestRate_mm_min = 1e6;
inline constexpr const char* kRateExpected = "a rate from 0.001 to 1000000 mm/min";
/// Ten turns: whoever states more means another unit, and far beyond a double has no angle left.
inline constexpr double kLargestAngle_deg = 3600;
inline constexpr const char* kAngleExpected = "an angle from -3600 to 3600 degrees";
/// Accelerations of a job, mm/s²: what takes a day to a millimetre per second is none, and 1000 g
/// tears the spindle off.
inline constexpr double kLeastAcceleration_mm_s2 = 1e-5;
inline constexpr double kLargestAcceleration_mm_s2 = 1e7;
inline constexpr const char* kAccelerationExpected =
    "an acceleration from 0.00001 to 10000000 mm/s2";
/// Scales of a cage or a mesh: from metres to micrometres is a million.
inline constexpr double kLeastScale = 1e-6;
inline constexpr double kLargestScale = 1e6;
inline constexpr const char* kScaleExpected = "a scale from 0.000001 to 1000000";
/// A machine's travel ends nearer than this to its zero: 1 km. mm.
inline constexpr double kFarthestTravelMm = 1e6;
inline constexpr const char* kTravelExpected = "limits within 1000000 mm (1 km) of zero";

}  // namespace limitgauge::app
