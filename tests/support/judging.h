#pragma once
// A part, a block, programs by hand, and what the verifier says of them at its own resolution.

#include <vector>

#include "tests/support/measuring.h"
#include "tests/support/rasters.h"

namespace limitgauge::tests {

inline model::BoxStock block_between(const model::Vec3& low, const model::Vec3& high) {
  return {low, high - low};
}

/// Straight feed moves through all tips.
inline model::Toolpath moves_through(const std::vector<model::Vec3>& tips) {
  model::Toolpath path;
  path.start = tips.front();
  for (std::size_t k = 1; k < tips.size(); ++k) feed_to(path, tips[k]);
  return path;
}
inline verifier::Pass pass_of(const model::Cutter& cutter, model::Toolpath path) {
  return {cutter, shared(std::move(path))};
}

inline verifier::GateLimits uncut_gate(double uncut_mm) {
  verifier::GateLimits limits;
  limits.has_uncut = true, limits.uncut_mm = uncut_mm;
  return limits;
}
inline verifier::GateLimits gouge_gate(double gouge_mm) {
  verifier::GateLimits limits;
  limits.has_gouge = true, limits.gouge_mm = gouge_mm;
  return limits;
}
inline verifier::GateLimits both_gates(double gouge_mm, double uncut_mm) {
  verifier::GateLimits limits = uncut_gate(uncut_mm);
  limits.has_gouge = true, limits.gouge_mm = gouge_mm;
  return limits;
}

struct Judged {
  verifier::StageDeviation deviation;
  verifier::GateDecision decision;
};

/// Measured and decided as a job does it by default: resolution "auto".
inline Judged judge(const verifier::ReferenceSurface& surface, const model::Stock& stock,
                    const std::vector<verifier::Pass>& passes, const verifier::GateLimits& limits,
                    double allowance_mm = 0) {
  verifier::StageCheck check;
  check.allowance_mm = allowance_mm;
  check.limits = limits;
  check.resolution_mm = verifier::automatic_resolution_mm(limits);
  check.field_spacing_mm = 0.5;
  Judged out;
  out.deviation = measure_passes(surface, stock, passes, check, 2);
  out.decision = verifier::decide(out.deviation, limits);
  return out;
}

/// Measured to a width, with nothing limited: both figures are narrowed wherever they lie.
inline verifier::StageDeviation measured(const verifier::ReferenceSurface& surface,
                                         const model::Stock& stock,
                                         const std::vector<verifier::Pass>& passes,
                                         double resolution_mm) {
  verifier::StageCheck check;
  check.resolution_mm = resolution_mm;
  check.field_spacing_mm = 0.5;
  return measure_passes(surface, stock, passes, check, 2);
}

}  // namespace limitgauge::tests
