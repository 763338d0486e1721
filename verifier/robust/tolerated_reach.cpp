#include "verifier/robust/tolerated_reach.h"

#include <algorithm>

namespace limitgauge::verifier {
namespace {

bool has_same_cutter(const Pass& a, const Pass& b) {
  return to_text(a.cutter) == to_text(b.cutter);
}

}  // namespace

ToleratedReach::Searched::Searched(const StageScene& scene, std::span<const Pass> passes,
                                   const StageCheck& check, double area_mm2,
                                   const model::RunControl& control)
    : by(scene.cells, passes, check.allowance_mm, area_mm2, check.limits.has_unreachable),
      proven(classify_reach(scene.cells, by.searches, by.efforts, control)),
      query(by.searches, proven) {}

ToleratedReach::ToleratedReach(const StageScene& scene, const model::Tolerances& tolerances,
                               std::span<const Pass> passes, const StageCheck& check,
                               double area_mm2, const ReachQuery& stated,
                               const model::RunControl& control)
    : any_(&stated), extreme_(&stated) {
  const ToleranceBox box(tolerances, passes);
  if (!box.changes_reach()) return;
  const auto search = [&](std::span<const Pass> with) {
    return std::make_unique<const Searched>(scene, with, check, area_mm2, control);
  };
  const std::vector<Pass> extreme = box.cutters_at(box.extreme(Side::uncut));
  const auto smallest = box.smallest_cutters();
  extreme_searched_ = search(extreme);
  extreme_ = any_ = &extreme_searched_->query;
  // The same but for corners' radii and necks.
  if (smallest && std::equal(extreme.begin(), extreme.end(), smallest->begin(), has_same_cutter))
    return;
  if (smallest) any_searched_ = search(*smallest);
  any_ = smallest ? &any_searched_->query : nullptr;
}

}  // namespace limitgauge::verifier
