#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "verifier/certificate/certificate.h"
#include "verifier/cutter/assembly.h"
#include "verifier/gate/deviation_field.h"
#include "verifier/gate/verify.h"
#include "verifier/reach/reach_map.h"

namespace limitgauge::verifier {

/// All that reach is judged by: the cutters used so far, each of its kind and each way it stood in
/// once, that of the last pass first.
struct ReachOfCutters {
  std::vector<model::Cutter> cutters;
  std::vector<Reachability> searches;
  std::vector<ReachOptions> efforts;

  /// `resolves_seams`: where the reach of cutters that stood otherwise meets, it is followed more
  /// finely, which a limit on the unreachable is decided by.
  ReachOfCutters(const SurfaceCells& cells, std::span<const Pass> passes, double allowance_mm,
                 double area_mm2, bool resolves_seams);
  ReachOfCutters(const ReachOfCutters&) = delete;
  ReachOfCutters& operator=(const ReachOfCutters&) = delete;

 private:
  /// S as it lies before cutters that stood in other ways: one each.
  std::vector<std::unique_ptr<const SurfaceCells>> turned_;
};

/// What a stage is measured in: built of the surface, the raw stock and the passes so far. Whoever
/// does a part of the measurement builds the same.
class StageScene {
 public:
  StageScene(const ReferenceSurface& surface, const model::Stock& raw_stock,
             std::span<const Pass> passes, const StageCheck& check);
  StageScene(const StageScene&) = delete;
  StageScene& operator=(const StageScene&) = delete;

  Spaces spaces() const {
    const RemovedSpace& fluted = fluted_ ? *fluted_ : cut;
    return {cut, swept_ ? *swept_ : fluted, fluted};
  }

  /// Of S moved out by the allowance: what stays above does not come near.
  const double highest_mm;
  const SurfaceCells cells;
  const RemovedSpace cut, raw;
  /// Shanks and holders that come near, of passes whose gouges count.
  const std::vector<AssemblySweep> parts;
  const ReachOfCutters by;
  const CertificateRequest request;

 private:
  std::optional<RemovedSpace> fluted_, swept_;  ///< where they are not `cut`
};

}  // namespace limitgauge::verifier
