#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/geometry/box_tree.h"
#include "verifier/cutter/cutter_profile.h"
#include "verifier/cutter/swept_body.h"

namespace limitgauge::verifier {

/// How far a box about zero, of half edges `half`, reaches in the direction of a vector, times the
/// vector's length.
double reach_of(const model::Vec3& way, const model::Vec3& half);

/// A box round the tips of some moves, tilted as the plane that lies nearest to them: where passes
/// follow a slope, one along the axes is many times as high as the sheet that the tips lie in, and
/// tells none of its moves from the others.
class TiltedBox {
 public:
  /// Holds nothing, and bounds nothing.
  TiltedBox() = default;
  explicit TiltedBox(std::span<const SweptBody> bodies);

  /// Whether `bound` says anything of a cutter: its side is upright and its bottom level or round.
  static bool serves(const CutterProfile& profile);
  /// A lower bound of d over all moves whose tips are in the box and all points no further from `p`
  /// along each axis than `half`, rounding taken off; that of an endless distance below where a
  /// point is not below all the tips' cores.
  double bound(const CutterProfile& profile, const model::Vec3& p,
               const model::Vec3& half = {}) const;

  /// Whether all cores are above all of those points, so that it says something.
  bool is_above(const CutterProfile& profile, const model::Vec3& p, const model::Vec3& half) const {
    return p.z - profile.core_mm + half.z <= lowest_z_;
  }
  /// Where it does, the square of how far the cores are, but for rounding.
  double square(const CutterProfile& profile, const model::Vec3& p, const model::Vec3& half) const;

 private:
  model::Vec3 normal_, side_, third_;  ///< of the sheet, upwards; a level one along it; across both
  model::Vec3 level_;                  ///< length of each of them in plan
  model::Vec3 low_, high_;             ///< along each of them
  double lowest_z_ = -1e300;
};

/// For the nodes of a tree over moves, but the largest, of which no plane is near to all.
std::vector<TiltedBox> tilted_boxes(const std::vector<model::BoxNode>& nodes,
                                    std::span<const SweptBody> bodies);

}  // namespace limitgauge::verifier
