#pragma once

#include <optional>
#include <vector>

#include "model/geometry/interval.h"
#include "verifier/cells/offset_cell.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// Which way along a normal of S.
enum class Way { outwards, inwards };

/// A lower bound of the first t in [from_mm, to_mm] at which the line from s along its normal n, or
/// against it, lies on S; to_mm where there is none. What lies within 1e-5 mm of t = 0 is s itself
/// where it faces as s does; what faces the other way there is the far side of a sharp edge,
/// and in the very same place only where both lie back to back.
double next_crossing_mm(const SurfaceCells& cells, const model::Vec3& s, const model::Vec3& n,
                        Way way, double from_mm, double to_mm);

/// A place where a segment goes through S, how far along it, and how often: from behind to before,
/// less the other way.
struct Crossing {
  model::Interval where;  ///< t of from + t·along, mm
  int times = 0;
};

/// The crossings of the segment of that length with S, in their order, each known to `finest_mm`
/// along it: by the degree of S's projection along it, which is how often the projected boundaries
/// of cells wind round it. None where the segment begins or ends too near to S, or meets the
/// boundary of a cell.
std::optional<std::vector<Crossing>> crossings(const SurfaceCells& cells, const model::Vec3& from,
                                               const model::Vec3& along, double length_mm,
                                               double finest_mm);

/// Proof that for every s of the cell the segment from s + low_mm·n(s) to s + high_mm·n(s), or the
/// other way, meets S at another place than s itself (CERTIFICATE.md, section 3b, statement 2).
/// False means "not proven".
bool surely_crosses_surface(const SurfaceCells& cells, const OffsetCell& cell, Way way,
                            double low_mm, double high_mm);

}  // namespace limitgauge::verifier
