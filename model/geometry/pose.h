#pragma once

#include <array>
#include <cmath>

#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// A rigid motion p ↦ R·p + t, which says how one frame lies in another: of a part in a machine, or
/// of a pass in the frame that its stock is asked in. R is a proper rotation but for rounding
/// (1e-15); what it does to a millimetre is right to some 1e-13 mm on parts of a metre.
struct Pose {
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  ///< of R
  Vec3 shift_mm;                                                          ///< t

  constexpr Vec3 direction(const Vec3& v) const {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  }
  constexpr Vec3 point(const Vec3& p) const { return direction(p) + shift_mm; }
  /// Rᵀ·v: a direction of the target frame as the other one has it.
  constexpr Vec3 direction_back(const Vec3& v) const {
    return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z;
  }
  constexpr Vec3 point_back(const Vec3& p) const { return direction_back(p - shift_mm); }
  Pose inverse() const;
  /// Half the extent of the axis-aligned box round a turned box of half extent `half`.
  Vec3 half(const Vec3& half) const;
  /// The axis-aligned box round a turned one; an empty one stays empty.
  Box3 box(const Box3& box) const;
  /// How much wider than a cube the box round the turned cube is: 1 to √3.
  double widening() const;
  /// Turns only by right angles about the axes, so that boxes stay boxes.
  bool keeps_axes() const;
  bool turns() const { return rows != Pose{}.rows; }

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// `first`, then `then`.
Pose operator*(const Pose& then, const Pose& first);

/// The turn by `angle_deg` about `axis` through the origin, right-handed; by quarters of a turn
/// about an axis of the frame it is exact. Throws std::invalid_argument for an axis of no length or
/// a number that is not finite.
Pose turn_about(const Vec3& axis, double angle_deg);

/// The one turn that a rotation is: right-handed by 0 to 180 degrees about a unit vector; about Z
/// by 0 where nothing turns.
struct Turn {
  Vec3 axis;
  double angle_deg = 0;
};
Turn turn_of(const Pose& pose);

/// The pose whose rotation is `rows`, made orthogonal where it is so within `tolerance`. Throws
/// std::invalid_argument where it is none within that, or mirrors.
Pose rotation_of(const std::array<Vec3, 3>& rows, double tolerance);

}  // namespace limitgauge::model
