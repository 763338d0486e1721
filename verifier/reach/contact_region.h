#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/part/cutter.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/cutter/cutter_profile.h"
#include "verifier/cutter/swept_body.h"
#include "verifier/reach/plan_cover.h"

/// Where a cutter may stand while it touches a cell of S, and how far its parts then are from a
/// point.
namespace limitgauge::verifier {

/// A convex part of a cutter as it stands, its lower end `lift_mm` over the tip: without end
/// upwards, or cut off where it ends.
struct StandingPart {
  CutterProfile profile;
  double lift_mm = 0;
  bool endless = true;
};

/// What stands on flutes, one cylinder on the other, each reaching into what it stands on or, where
/// it is the wider one, that into it.
std::vector<StandingPart> necked_parts(const CutterProfile& flutes, double top_mm,
                                       std::span<const model::CylinderPart> cylinders);

/// Tip positions core + (r·cos θ, r·sin θ, −z), each as far as `stray_mm` from it, for r, θ and z
/// in ranges and every core in the hull of four points.
struct ContactRegion {
  std::array<model::Vec3, 4> cores;
  double r0 = 0, r1 = 0, angle0 = 0, angle1 = 0, z0 = 0, z1 = 0;
  double stray_mm = 0;
};

/// Four corners of a rectangle through the middle of a cell, along its longer way, and how far its
/// control points lie from it at most: the cell is within that of the rectangle's hull.
struct CellRectangle {
  std::array<model::Vec3, 4> corners;
  double thickness_mm = 0;
};
CellRectangle rectangle_round(const Bezier& cell, const model::Vec3& normal);

/// The position in the middle of a region.
model::Vec3 middle_tip(const ContactRegion& region);

/// A piece of a region in plan: what is asked of it for one obstacle after the other.
class PlanPiece {
 public:
  explicit PlanPiece(const ContactRegion& g);

  /// The place round a core that is farthest in plan from p: straight away from it on the outer
  /// arc, else a corner.
  model::Vec3 farthest(const model::Vec3& core, const model::Vec3& p) const;

 private:
  double outer_, cos_half_;
  model::Vec3 middle_;
  std::array<model::Vec3, 4> corners_;
};

/// A hull that holds the tips of a piece in plan: cores and, added, the sector within its tangents.
PlanHull hull_of(const ContactRegion& piece);

/// Signed distance from p to a part whose cutter stands with its tip at `tip`, and its plane.
BodyDistance part_plane(const StandingPart& part, const model::Vec3& tip, const model::Vec3& p);

/// Greatest signed distance from p to a part over all positions of a piece, and its plane: the
/// distance grows with the one in plan, and is convex in the tip's height and core.
BodyDistance greatest_distance(const StandingPart& part, const ContactRegion& piece,
                               const PlanPiece& plan, const model::Vec3& p);

/// A lower bound of the signed distance from the points of a box to a part of a cutter with its tip
/// at `tip`.
double part_bound_mm(const StandingPart& part, const model::Vec3& tip, const model::Box3& box);

}  // namespace limitgauge::verifier
