#pragma once

#include "model/base/run_control.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/gate/deviation.h"
#include "verifier/reach/reach_query.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {

/// What runs are measured in: flutes and raw stock for material; for what was removed, flutes of
/// passes whose gouges count, and shanks and holders besides. One space where these come nowhere
/// near and all passes count.
struct Spaces {
  const RemovedSpace& cut;
  const RemovedSpace& swept;
  const RemovedSpace& fluted;
};

/// Fills in the runs, reachability and the nearest pass of every sample. Returns the position that
/// touches each reachable sample, beside the samples.
std::vector<ReachQuery::Touch> measure_field(DeviationField& field, const SurfaceCells& cells,
                                             const Spaces& spaces, const ReachQuery& reach,
                                             std::span<const Pass> passes, double allowance_mm,
                                             const model::RunControl& control);

/// Samples are taken so many at a time: what one knows of the nearest pass is where the next one
/// looks first, within these. Parts of a field begin at multiples of it.
inline constexpr std::size_t kFieldChunk = 512;

/// The same of the samples from `begin` on and before `end`; touches of these alone are filled in.
void measure_samples(DeviationField& field, std::vector<ReachQuery::Touch>& touches,
                     std::size_t begin, std::size_t end, const SurfaceCells& cells,
                     const Spaces& spaces, const ReachQuery& reach, std::span<const Pass> passes,
                     double allowance_mm, const model::RunControl& control);

/// The deepest sample whose allowance surface lies outside the raw stock; the first of equal ones.
std::optional<StageDeviation::MissingAllowance> missing_allowance(const DeviationField& field,
                                                                  const SurfaceCells& cells,
                                                                  const RemovedSpace& raw,
                                                                  double allowance_mm,
                                                                  const model::RunControl& control);

/// Fills in the area-weighted figures of `out` from its field: areas, coverage, mean, rms,
/// percentiles and histogram of deviation − allowance over the reachable samples.
void summarize_field(StageDeviation& out, const GateLimits& limits);

}  // namespace limitgauge::verifier
