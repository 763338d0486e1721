#pragma once

#include <optional>

#include "model/base/run_control.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/certificate/cell_search.h"
#include "verifier/gate/deviation.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// Two-sided bounds of the longest run of one kind over S (definition 2); never negative. `low` is
/// a run proven at a point of S (of uncut: one that can be touched), less what chords and rounding
/// may add; `high` is proven of every cell, but for those that are proven to be out of reach.
struct Certificate {
  Interval figure_mm;
  std::optional<Witness> witness;
  std::size_t cells = 0;
  bool reached_resolution = true;
};

/// Certifies one figure of a removed space: of uncut over all that `reach` does not prove to be out
/// of reach, sharp edges with all their normals included; of gouge, and of missing stock (in a
/// space of raw stock alone), over all of S, for which `reach` is not asked.
/// Branch and bound over the cells, worst first. Batches of fixed size see the best values of the
/// batches before them only, so the result is the same for any number of threads.
/// Of a space that sways `high` holds for all its shifts, and `low` is looked for in `draws`.
Certificate certify(const SurfaceCells& cells, const RemovedSpace& space, Side side,
                    const ReachQuery* reach, const CertificateRequest& request,
                    const model::RunControl& control, const Draws* draws = nullptr);

}  // namespace limitgauge::verifier
