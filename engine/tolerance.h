#pragma once

/// The engine's tolerances: value, unit and reason of each. Shares of a stage's tolerance, which
/// say what part of it each step may use, stand where they are used.

namespace limitgauge::engine {

/// Two computations of one place agree within this: far above the rounding of coordinates below
/// 10 m, far below any step of a machine.
inline constexpr double kSamePlace_mm = 1e-9;
/// Share of a square, or of a sum of a few terms, that its rounding may take.
inline constexpr double kUnitRounding = 1e-14;
/// Sine of the angle under which two edges count as one line.
inline constexpr double kCollinear = 1e-9;
/// Area of a triangle, in pixels of its raster, below which its plane says nothing.
inline constexpr double kSliver_px2 = 1e-9;
/// What a straight line climbs across a row of a raster below which it is level, relative.
inline constexpr double kLevelLine = 1e-12;
/// A length that is a whole number of steps but for this share of one is that number.
inline constexpr double kWholeStep = 1e-6;

/// Heights of cutter locations are never below the truth, and above it by at most this.
inline constexpr double kHeightError_mm = 1e-6;
/// Contacts lie above the truth by at most this: a tenth of kHeightError_mm.
inline constexpr double kContactError_mm = 1e-7;
/// What a search for the greatest lift may leave behind.
inline constexpr double kSearchSlack_mm = 3e-7;
/// Added to what a search finds, so that a move lifted by it is found clear; with the contacts'
/// error the sum stays within kHeightError_mm.
inline constexpr double kResultSlack_mm = kSearchSlack_mm + 2 * kContactError_mm;
/// Upper bounds of lifts are raised by this against rounding: far below kContactError_mm.
inline constexpr double kBoundSlack_mm = 1e-10;
/// Points this far beyond the body's reach are still taken to be under it: an upright wall touched
/// by the side must not be lost to rounding.
inline constexpr double kReachSlack_mm = kSamePlace_mm;
/// Edges shorter than this, seen from above, are upright: the rounding of one coordinate.
inline constexpr double kUprightLength_mm = 1e-12;
/// Facets steeper than this (tangent of the slope) count as upright: their edges speak for them.
inline constexpr double kUpright = 1e6;

/// Waterlines run this much above the height asked for: a plateau there, flat but for rounding and
/// kHeightError_mm, is free as a whole instead of torn into islands.
inline constexpr double kAbovePlateaus_mm = 1e-5;
/// Width to which steps in height and the ends of runs are found: the last digit of programs.
inline constexpr double kStepWidth_mm = 1e-4;
/// Ramps are this much flatter than asked for, as a share, against rounding of heights.
inline constexpr double kFlatter = 1 - 1e-6;

}  // namespace limitgauge::engine
