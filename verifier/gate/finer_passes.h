#pragma once

#include <span>
#include <vector>

#include "verifier/certificate/certificate.h"
#include "verifier/cutter/assembly.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {

/// Passes without those that are left out: of these no move, so that all keep their places.
std::vector<Pass> without(std::span<const Pass> passes, std::span<const std::size_t> left_out);
/// As they gouge, for a stage to which what finer ones took is no gouge.
std::vector<Pass> gouging(std::span<const Pass> passes, std::span<const FinerPass> finer);

/// What is measured, and how narrowly.
struct FinerScene {
  const SurfaceCells& cells;
  std::span<const Pass> passes;
  std::span<const AssemblySweep> parts;  ///< shanks and holders of passes whose gouges count
  const model::Stock& raw_stock;
  const CertificateRequest& request;
};

/// Below what finer passes left, nobody may take more than they might: where they took all that
/// this stage was to leave, it would show no gouge however deep it went. For each allowance of
/// finer passes, all but still finer ones are measured against it, shanks and holders included.
/// What exceeds the finer passes' limit is gouge of the stage, by as much deeper as it has more to
/// leave: takes `gouge` up to that, and returns what is found, to its depth below the stage's own
/// allowance. Statement and proof: CERTIFICATE.md, section 11.
std::vector<Finding> gouge_below_finer(const FinerScene& scene, std::span<const FinerPass> finer,
                                       Certificate& gouge, const model::RunControl& control);

}  // namespace limitgauge::verifier
