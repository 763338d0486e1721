#pragma once

#include "verifier/gate/deviation.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {

/// Samples of S, each with the area it stands for; deviations are not filled in yet. In every
/// patch a grid of parameters with no two neighbours further apart than `spacing_mm` on average
/// along a grid line. A facet of a mesh has one grid for its three patches: columns square to its
/// longest side, no further apart than `spacing_mm`, the corner opposite in one of them. No point
/// of it is further than `spacing_mm` from a sample, and the samples are as many as its area asks
/// for, however long and thin it is.
DeviationField sample_surface(const ReferenceSurface& surface, double spacing_mm);

}  // namespace limitgauge::verifier
