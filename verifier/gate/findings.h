#pragma once

#include "verifier/certificate/exceedance.h"
#include "verifier/cutter/assembly.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {

/// At most this many findings of a kind are kept, the deepest.
inline constexpr std::size_t kMostFindings = 200;
/// Spots with less than this between them belong to one finding.
inline constexpr double kTogether_mm = 0.4;

/// Gathers spots, and the certificate's witness, into findings, deepest first. `parts` are the
/// sweeps that `space`, whose bodies the spots name, may hold after the passes.
std::vector<Finding> gather_findings(const Exceedance& found, const std::optional<Witness>& witness,
                                     std::span<const Pass> passes,
                                     std::span<const AssemblySweep> parts,
                                     const RemovedSpace& space);

/// Names the passes around each leftover: moves about as near as the nearest, one of each run of
/// consecutive moves.
void name_passes(std::vector<Finding>& leftovers, const RemovedSpace& space,
                 std::span<const Pass> passes);

/// Deepest first; the most that are kept.
void keep_deepest(std::vector<Finding>& findings);

}  // namespace limitgauge::verifier
