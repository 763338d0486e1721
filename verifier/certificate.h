#pragma once

#include <limits>
#include <optional>

#include "engine/model/run_control.h"
#include "verifier/cell_bounds.h"
#include "verifier/deviation.h"
#include "verifier/reach_query.h"
#include "verifier/surface_cells.h"

namespace limitgauge::verifier {

struct CertificateRequest {
  double allowance_mm = 0;
  /// Limits of the gate: a figure proven to be beyond its limit is not narrowed down further than
  /// to a twentieth of itself, for its verdict is settled.
  double gouge_limit_mm = std::numeric_limits<double>::infinity();
  double uncut_limit_mm = std::numeric_limits<double>::infinity();
  /// Widest interval wanted. Where a limit lies within an interval of that width, it is narrowed
  /// further, down to a hundredth of it, until the verdict is settled.
  double resolution_mm = 0;
  std::size_t largest_cell_count = 0;  ///< where refinement ends all the same
};

/// A point of S that shows that an interval's low end is truly reached.
struct Witness {
  SurfacePlace place;
  double depth_mm = 0;
  BodyRef body;
};

/// Two-sided bounds of the deepest gouge, max (a − δ), over S and of the largest uncut, max (δ −
/// a), over the part of S that is not surely unreachable; never negative. `low` is δ at a point of
/// S (for uncut: at one that can be touched), less what chords and rounding may add; `high` is a
/// bound on every cell, of a gouge on its depth in the union of all bodies (UnionDepth).
struct Certificate {
  Interval gouge_mm, uncut_mm;
  std::optional<Witness> gouge, uncut;
  std::size_t cells = 0;
  bool reached_resolution = true;
};

/// What rounding in double precision and the points omitted near irregular vertices may add to any
/// distance: coordinates below 10 m, far above the true error.
inline constexpr double kRounding_mm = 1e-9 + SurfaceCells::kOmitted_mm;

/// Without `reach` gouge alone is certified and uncut is empty, as for a shank.
/// Branch and bound over the cells, worst first. Batches of fixed size see the best values of the
/// batches before them only, so the result is the same for any number of threads.
Certificate certify(const SurfaceCells& cells, const RemovedSpace& space, const ReachQuery* reach,
                    const CertificateRequest& request, const model::RunControl& control);

}  // namespace limitgauge::verifier
