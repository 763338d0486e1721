#pragma once

#include <optional>

#include "model/geometry/vec2.h"
#include "verifier/cells/offset_cell.h"
#include "verifier/cutter/cutter_profile.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// Where the tip stands while a cutter touches the points s of one cell, at distance a:
///   T(s) = s + (rounding + a)·n(s) + flat·e(s) − rounding·z,   e = n_xy/|n_xy|,
/// seen from the position T₀ of the middle. n stays within an angle α of the cone's axis n₀, and e
/// within β of e₀, sin β = sin α / sin(tilt).
class CellContact {
 public:
  /// Empty where the cell has no cone of normals narrow enough to reason with, and for a bottom
  /// that rises or a side that leans inwards: the proofs below and in `LocalContact` do not cover
  /// them.
  static std::optional<CellContact> of(const OffsetCell& cell, const CutterProfile& profile,
                                       double allowance_mm);

  /// Every normal of the cell points further down than the cutter's wall leans.
  bool too_steep() const { return tilt_ - alpha_ > steepest_ + kLean_rad; }
  /// Every normal lets the cutter touch, to an angle far below any tolerance.
  bool touchable() const { return tilt_ + alpha_ <= steepest_ + kContactTurn_rad; }
  /// All normals are vertical to 1e-6: the flat may touch with any of its points, and misses the
  /// others by less than a millionth of its width.
  bool level() const { return tilt_ + alpha_ <= kContactTurn_rad; }
  /// The flat's direction e is not bounded: the cutter is taken to stand anywhere around.
  bool turning() const { return turning_; }
  /// Nor is it where some normal is as good as level.
  bool may_stand_around() const { return turning_ || (flat_ > 0 && tilt_ - alpha_ <= kLean_rad); }
  /// On a level cell: the contact that has the axis displaced by `shift` for all of its points.
  CellContact displaced(const model::Vec3& shift) const;

  const OffsetCell& offset() const { return cell_; }
  const model::Vec3& middle() const { return cell_.middle; }
  const model::Vec3& normal() const { return cell_.normal; }
  const model::Vec3& direction() const { return direction_; }
  const model::Vec3& tip() const { return tip_; }
  /// The cutter; where the direction is not bounded one with twice the flat, at the middle of all.
  const CutterProfile& profile() const { return profile_; }
  double alpha() const { return alpha_; }
  double beta() const { return beta_; }
  double tilt() const { return tilt_; }
  double radius() const { return radius_; }
  /// Greatest |T(s) − T₀|.
  double stray() const { return stray_; }

  /// Greatest g·(T(s) − T₀).
  double largest_shift(const model::Vec3& g) const;
  /// Of it what normals turn that way take: the rest is from 0 to radius() for a unit vector g.
  double turning_shift(const model::Vec3& g) const;
  /// Greatest n(s)·(q − s) over the cell and over all q with n₀·q ≤ `along` within `apart` of the
  /// middle. The contact plane bounds the cutter: d(q − T(s)) ≥ a − n(s)·(q − s).
  double over_contact_plane(double along, double apart) const;
  /// Whether the cell keeps to all its own contact planes, within `tolerance_mm`: what touches a
  /// point of it does not cut into the others.
  bool clears_itself(double tolerance_mm) const;

 private:
  CellContact(const OffsetCell& cell, const CutterProfile& profile)
      : cell_(cell), profile_(profile) {}

  OffsetCell cell_;
  CutterProfile profile_;
  model::Vec3 direction_, tip_;
  double reach_ = 0;  ///< rounding + allowance
  double flat_ = 0;   ///< the flat's part in the shift of the tip
  model::Vec2 turn_by_alpha_{0, 0}, turn_by_beta_{0, 0};  ///< sine, and one less the cosine
  double alpha_ = 0, beta_ = 0, tilt_ = 0, steepest_ = 0, radius_ = 0, stray_ = 0;
  double lowest_along_ = 0;  ///< least n₀·s
  bool turning_ = false;
};

}  // namespace limitgauge::verifier
