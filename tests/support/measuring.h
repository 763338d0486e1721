#pragma once

#include <span>
#include <vector>

#include "verifier/gate/verify.h"

namespace limitgauge::tests {

/// The one place where these tests call the verifier, on raw stock and passes alone: without the
/// second instrument.
inline verifier::StageDeviation measure_passes(const verifier::ReferenceSurface& surface,
                                               const model::Stock& stock,
                                               std::span<const verifier::Pass> passes,
                                               const verifier::StageCheck& check,
                                               unsigned threads = 1) {
  return verifier::measure_stage(surface, stock, passes, nullptr, check, {threads, nullptr, {}});
}

}  // namespace limitgauge::tests
