#pragma once

#include "verifier/deviation.h"
#include "verifier/reach_map.h"

namespace limitgauge::verifier {

/// Whether places and cells of S can be touched: as the map has proven of the cells that hold them,
/// else by a search for each. Both with the same cutter, allowance and contact tolerance.
class ReachQuery {
 public:
  ReachQuery(const Reachability& search, const ReachMap& proven)
      : search_(search), proven_(proven) {}

  /// A proof that a gouge-free position touches S at the place, where its unit normal is `normal`.
  bool can_be_touched(const SurfacePlace& place, const model::Vec3& normal) const;
  /// That position.
  std::optional<model::Vec3> touching_tip(const SurfacePlace& place,
                                          const model::Vec3& normal) const;
  /// Proof that no point of the cell can be touched. False means "not proven".
  bool surely_unreachable(const SurfaceCell& cell) const;

 private:
  const Reachability& search_;
  const ReachMap& proven_;
};

}  // namespace limitgauge::verifier
