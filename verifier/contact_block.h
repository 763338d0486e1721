#pragma once

#include <optional>
#include <vector>

#include "verifier/cutter_profile.h"
#include "verifier/surface_cells.h"

namespace limitgauge::verifier {

/// A convex part of a cutter as it stands, its lower end `lift_mm` over the tip: without end
/// upwards, or cut off where it ends.
struct StandingPart {
  CutterProfile profile;
  double lift_mm = 0;
  bool endless = true;
};

/// Tip positions core + (r·cos θ, r·sin θ, −z), each as far as `stray_mm` from it, for r, θ and z
/// in ranges.
struct ContactRegion {
  model::Vec3 core;
  double r0 = 0, r1 = 0, angle0 = 0, angle1 = 0, z0 = 0, z1 = 0;
  double stray_mm = 0;
};

/// Proof that a cutter made of parts comes nearer than a limit to S from every position of a
/// region: the distance to a part is convex in its position, so a point of S that is near enough at
/// all corners of a piece of the region is near enough in all of it, but for the bulge of an arc
/// over its chord. Pieces are halved where that does not hold.
class ContactBlock {
 public:
  ContactBlock(const SurfaceCells& cells, const std::vector<StandingPart>& parts, double limit_mm)
      : cells_(cells), parts_(parts), limit_mm_(limit_mm) {}

  /// False means "not proven".
  bool blocks(const ContactRegion& region) const;

 private:
  struct Obstacle {
    model::Vec3 point;
    std::size_t part = 0;
  };
  bool blocks(const ContactRegion& region, std::optional<Obstacle> known, int& effort) const;
  bool holds(const ContactRegion& region, const Obstacle& obstacle) const;
  std::optional<Obstacle> deep_obstacle(const model::Vec3& tip, double limit_mm,
                                        bool any = false) const;

  const SurfaceCells& cells_;
  const std::vector<StandingPart>& parts_;
  double limit_mm_;
};

/// Signed distance from a point to a part of a cutter with its tip at `tip`, and a lower bound of
/// it over a box.
double part_distance_mm(const StandingPart& part, const model::Vec3& tip, const model::Vec3& p);
double part_bound_mm(const StandingPart& part, const model::Vec3& tip, const model::Box3& box);

}  // namespace limitgauge::verifier
