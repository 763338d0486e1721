#pragma once

#include "verifier/cells/offset_cell.h"
#include "verifier/cells/surface_crossing.h"

namespace limitgauge::verifier {

/// Proof that for every s of the cell the segment from s + low_mm·n(s) to s + high_mm·n(s), or the
/// other way, meets S at another place than s itself (CERTIFICATE.md, section 3b, statement 2).
/// False means "not proven".
bool surely_crosses_surface(const SurfaceCells& cells, const OffsetCell& cell, Way way,
                            double low_mm, double high_mm);

}  // namespace limitgauge::verifier
