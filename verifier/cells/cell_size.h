#pragma once

/// How small cells of S may become, mm.
namespace limitgauge::verifier {

/// Searches halve no cell whose control points lie this near to its middle: what they ask stays
/// undecided there.
inline constexpr double kSmallestCell_mm = 1e-6;

/// Pieces within this of an irregular vertex have the normal of the next piece beyond: theirs are
/// lost in rounding, and the vertex's own may be a limit that nothing comes near to.
inline constexpr double kVertexNormal_mm = 1e-6;

}  // namespace limitgauge::verifier
