#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tests/defects/oracle.h"
#include "tests/defects/orientations/posting.h"

namespace limitgauge::tests::defects {

/// The oracle of definition 2 for tools that stand several ways in the part. It is asked in the
/// part's frame, or in one in which a tool stands upright where that leans; what the setups of a
/// job come to it does not see.
class TurnedOracle {
 public:
  /// `part` and `stock` lie in the part's frame. `truly` are the stretches to be counted.
  TurnedOracle(const Target& part, const model::Cage& cage, const model::BoxStock& stock,
               const model::Cutter& cutter, std::span<const Stretch> truly, double allowance_mm);

  double surely_gouged_mm(const std::vector<Place>& hints) const;
  double surely_uncut_mm(const std::vector<Place>& hints) const;
  double possibly_gouged_mm(const Place& place) const;
  double possibly_uncut_mm(const Place& place) const;
  /// What stands over a place along its normal, in reach or not.
  double standing_mm(const Place& place) const;

 private:
  struct View;
  std::vector<std::shared_ptr<const View>> views_;
};

}  // namespace limitgauge::tests::defects
