#pragma once

#include <limits>
#include <optional>

#include "model/base/run_control.h"
#include "verifier/cells/cell_bounds.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/certificate/run_tracer.h"
#include "verifier/gate/deviation.h"
#include "verifier/reach/reach_query.h"

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
  BodyRef body;  ///< that a gouge was swept by, or that is nearest to a leftover's place
  model::Vec3 normal;
};

/// Two-sided bounds of the longest run of one kind over S (definition 2); never negative. `low` is
/// a run proven at a point of S (of uncut: one that can be touched), less what chords and rounding
/// may add; `high` is proven of every cell, but for those that are proven to be out of reach.
struct Certificate {
  Interval figure_mm;
  std::optional<Witness> witness;
  std::size_t cells = 0;
  bool reached_resolution = true;
};

/// What rounding in double precision and the vertices that stand for the points about them may add
/// to any distance: coordinates below 10 m, far above the true error.
inline constexpr double kRounding_mm = 1e-9 + SurfaceCells::kOmitted_mm;

/// Certifies one figure of a removed space: of uncut over all that `reach` does not prove to be out
/// of reach, sharp edges with all their normals included; of gouge, and of missing stock (in a
/// space of raw stock alone), over all of S, for which `reach` is not asked.
/// Branch and bound over the cells, worst first. Batches of fixed size see the best values of the
/// batches before them only, so the result is the same for any number of threads.
Certificate certify(const SurfaceCells& cells, const RemovedSpace& space, Side side,
                    const ReachQuery* reach, const CertificateRequest& request,
                    const model::RunControl& control);

}  // namespace limitgauge::verifier
