#pragma once

#include <optional>
#include <span>
#include <vector>

#include "verifier/cells/surface_cells.h"
#include "verifier/reach/contact_region.h"

namespace limitgauge::verifier {

/// A point of S that bars a part of a cutter from some positions.
struct ContactObstacle {
  model::Vec3 point;
  std::size_t part = 0;
};
/// What proofs about one cutter met last: they begin with it, so that one for a neighbour is short.
using ContactMemory = std::vector<ContactObstacle>;

/// Proof that a cutter made of parts comes nearer than a limit to S from every position of a
/// region: of one point of S, the distance to a part grows with the one in plan, which is greatest
/// at the far end of a piece of the region, and is convex in the core and the height. Of level
/// positions one point bars a disc, and several points together whatever lies in the union of
/// theirs. Pieces are halved where neither serves, until they are as small as the hull of their
/// cores.
class ContactBlock {
 public:
  ContactBlock(const SurfaceCells& cells, const std::vector<StandingPart>& parts, double limit_mm)
      : cells_(cells), parts_(parts), limit_mm_(limit_mm) {}

  /// False means "not proven". What was met is left in the memory, if there is one.
  bool blocks(const ContactRegion& region, ContactMemory* memory = nullptr) const;
  /// A position of the region from which the cutter comes no nearer than the limit to S, if one was
  /// found; of several cores, from the middle.
  std::optional<model::Vec3> free_tip(const ContactRegion& region) const;
  /// A point of S nearer than the limit to the cutter at `tip`, nearly the deepest in it.
  std::optional<ContactObstacle> deepest(const model::Vec3& tip) const {
    return obstacle_at(tip, limit_mm_, false);
  }

 private:
  using Obstacle = ContactObstacle;
  struct Search;
  std::optional<ContactRegion> free_spot(const ContactRegion& region, Search& search) const;
  bool learn_corners(const ContactRegion& piece, Search& search) const;
  bool is_spot_barred(const ContactRegion& spot, Search& search) const;
  double barred_mm(const ContactRegion& spot, const Search& search) const;
  ContactRegion least_barred(const ContactRegion& region, const Search& search) const;
  bool blocks(const ContactRegion& piece, Search& search) const;
  bool any_holds(const ContactRegion& piece, std::span<const Obstacle> obstacles) const;
  bool all_hold(const ContactRegion& piece, std::span<const Obstacle> obstacles) const;
  double barred_radius_mm(const Obstacle& obstacle, double tip_z_mm, double limit_mm) const;
  std::optional<Obstacle> obstacle_at(const model::Vec3& tip, double limit_mm, bool any) const;
  std::optional<Obstacle> obstacle_of(const ContactRegion& piece) const;

  const SurfaceCells& cells_;
  const std::vector<StandingPart>& parts_;
  double limit_mm_;
};

}  // namespace limitgauge::verifier
