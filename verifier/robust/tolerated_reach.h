#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "verifier/gate/stage_scene.h"
#include "verifier/reach/reach_query.h"
#include "verifier/robust/tolerance_box.h"

namespace limitgauge::verifier {

/// What any of the cutters of a box of tolerances can touch (CERTIFICATE.md, section 10): a place
/// is out of reach over the tolerances where none of them can.
class ToleratedReach {
 public:
  /// `stated` is the reach of the stated cutters, which it is where no figure of a cutter but its
  /// length is uncertain. Searches in `scene` otherwise, which must outlive it. Throws Interrupted.
  ToleratedReach(const StageScene& scene, const model::Tolerances& tolerances,
                 std::span<const Pass> passes, const StageCheck& check, double area_mm2,
                 const ReachQuery& stated, const model::RunControl& control);

  /// Of all cutters of the box together: what it proves to be out of reach is so to each of them.
  /// Null where no cutter stands for them: nothing is proven to be out of reach then.
  const ReachQuery* of_any() const { return any_; }
  /// Of the cutters that leave most.
  const ReachQuery* of_extreme() const { return extreme_; }

 private:
  /// What one choice of cutters reaches.
  struct Searched {
    ReachOfCutters by;
    ReachMap proven;
    ReachQuery query;
    Searched(const StageScene& scene, std::span<const Pass> passes, const StageCheck& check,
             double area_mm2, const model::RunControl& control);
  };

  std::unique_ptr<const Searched> any_searched_, extreme_searched_;
  const ReachQuery *any_, *extreme_;
};

}  // namespace limitgauge::verifier
