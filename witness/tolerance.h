#pragma once

/// The witness's tolerances: value, unit and reason of each. How its bounds follow from them stands
/// in bounds.h.

namespace limitgauge::witness {

/// Error that the surface under test states for itself, as a part of the size of its coordinates
/// (verifier/surface/reference_surface.h).
inline constexpr double kEvaluation = 1e-12;
/// Normals whose bound is wider say nothing, and are left out.
inline constexpr double kSteady_rad = 1e-3;

}  // namespace limitgauge::witness
