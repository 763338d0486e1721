#pragma once

#include <limits>
#include <span>
#include <vector>

#include "model/geometry/box_tree.h"
#include "verifier/cutter/cutter_profile.h"
#include "verifier/cutter/turning_body.h"

namespace limitgauge::verifier {

/// A cone that holds the axes of some turning bodies at all times: as the box round their cores
/// says where they are, it says how they stand.
class AxisCone {
 public:
  /// Holds every axis.
  AxisCone() = default;
  explicit AxisCone(const TurningBody& body);
  explicit AxisCone(std::span<const TurningBody> bodies);

  /// A lower bound of d over all bodies whose axes are in the cone and whose cores are in `cores`,
  /// and all points no further from `p` along each axis than `half`; rounding is taken off.
  /// `size_mm` is that of `farthest_from_core_mm`; nothing better than `enough_mm` is looked for.
  double bound(const CutterProfile& profile, double size_mm, const model::Box3& cores,
               const model::Vec3& p, const model::Vec3& half,
               double enough_mm = std::numeric_limits<double>::infinity()) const;

 private:
  double standing_bound(const CutterProfile& profile, const model::Vec3& room,
                        const model::Vec3& from, double enough_mm) const;
  bool is_below(double height, double far_square, double radius_square) const;

  model::Vec3 axis_;
  double spread_rad_ = 0;  ///< of no length: every axis
};

/// No place of a profile is further from its core.
double farthest_from_core_mm(const CutterProfile& profile);

/// For the nodes of a tree over turning bodies.
std::vector<AxisCone> axis_cones(const std::vector<model::BoxNode>& nodes,
                                 std::span<const TurningBody> bodies);

}  // namespace limitgauge::verifier
