#pragma once

#include "verifier/certificate.h"
#include "verifier/verify.h"

namespace limitgauge::verifier {

enum class Side { gouge, uncut };

/// Samples deeper than `threshold_mm` on one side, and the certificate's witness, gathered into
/// findings: neighbours on the surface belong together. Deepest first, at most kMostFindings.
/// Uncut counts on the reachable part only.
inline constexpr std::size_t kMostFindings = 200;
std::vector<Finding> find_clusters(const DeviationField& field, Side side, double threshold_mm,
                                   const std::optional<Witness>& witness,
                                   std::span<const Pass> passes, double spacing_mm);

}  // namespace limitgauge::verifier
