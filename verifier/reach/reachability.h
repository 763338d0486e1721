#pragma once

#include <optional>
#include <span>
#include <vector>

#include "verifier/cells/offset_cell.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/cutter/cutter_profile.h"
#include "verifier/reach/contact_block.h"

namespace limitgauge::verifier {

/// What a normal is one of: of a face, whose last digits may be those of its coordinates, or of a
/// sharp edge, between those of its faces, which are as they are.
enum class NormalOf { face, edge };

/// Which points of S a cutter can touch, at distance `allowance`, without coming closer than that
/// to S anywhere. Where nothing narrower than the flutes is stated above them the wall counts as
/// going up without end; a neck is judged as it is stated, so that the flutes may stand under a
/// ledge, and goes up without end. What is wider than the flutes is judged as collisions. Contact
/// on a point with normal n:
///   tip = s + (rounding + a)·n + flat·n_xy/|n_xy| − core·z,
/// and no contact where n points further down than the wall allows (n_z < sin of the taper), but
/// for flutes over which there is a neck, whose top can touch from below. Where the bottom rises
/// more steeply than S, its sharp tip touches: tip = s + a·n. A face that is level, as steep as the
/// bottom, or leans as the wall does, to kLean_rad, is touched as if it were so exactly: by the
/// flat all round, by the wall. What a side that leans inwards reaches from below is proven neither
/// to be touched nor not to be.
class Reachability {
 public:
  /// A position counts as free of gouges when it comes no closer than the allowance less
  /// `contact_mm`: the smaller, the longer a proof takes. Larger values count more as reachable.
  Reachability(const SurfaceCells& cells, const CutterProfile& profile, double allowance_mm,
               double contact_mm);
  /// With a neck, where the cutter has one.
  Reachability(const SurfaceCells& cells, const model::Cutter& cutter, double allowance_mm,
               double contact_mm);

  /// A gouge-free tip position that touches the surface at `p` with normal `n`, if one was proven.
  std::optional<model::Vec3> touching_tip(const model::Vec3& p, const model::Vec3& n,
                                          NormalOf of = NormalOf::face) const;
  /// A position, if one was proven to be free of gouges, whose flat stands on every point of a
  /// level cell: each is under it, and their heights are one but for rounding.
  std::optional<model::Vec3> tip_over_all(const Bezier& level) const;
  /// Where the tip is that touches the surface at `p` with normal `n`, whatever it cuts into
  /// elsewhere. Empty where the wall leans too far, and where S is level under a flat, which can
  /// touch it from any side, or as steep as a rising bottom, which can touch it all along.
  std::optional<model::Vec3> contact_tip(const model::Vec3& p, const model::Vec3& n,
                                         NormalOf of = NormalOf::face) const;
  /// Proof that the cutter standing with its tip at `tip` is free of gouges. False means "not
  /// proven".
  bool surely_free(const model::Vec3& tip) const {
    return comes_below(parts_, tip, allowance_mm_ - contact_mm_) == Below::none;
  }
  /// Proof that no point of the cell can be touched, with none of the cell's normals. False means
  /// "not proven". What proofs for neighbours met may be kept in a memory, and begins the next.
  bool surely_unreachable(const OffsetCell& cell, ContactMemory* memory = nullptr,
                          NormalOf of = NormalOf::face) const;
  /// Whether it may be proven of a cell at all: not of a cutter that can touch with its side from
  /// below.
  bool may_prove_unreachable() const;
  /// Whether proofs by the endless wall alone say that a place is out of reach: not of a cutter
  /// that has less above its flutes than that.
  bool is_endless() const { return !narrower_above_ && !among_others_; }

  /// The same search as one for a cutter that stands along +Z of the frame that `cells` is in, the
  /// cells of S one by one: `to_own` is how the frame of the caller lies in it. What is asked here
  /// is asked in that frame of the cutter's own.
  Reachability from(const SurfaceCells& cells, const model::Pose& to_own) const;
  const model::Pose& to_own() const { return to_own_; }
  /// The same search for a cutter that stood in other ways too, which are not all looked at: that
  /// nothing touches a place is never proven by it.
  Reachability among_others() const;
  bool is_among_others() const { return among_others_; }
  const SurfaceCells& cells() const { return *cells_; }

  const CutterProfile& profile() const { return profile_; }
  double allowance_mm() const { return allowance_mm_; }
  double contact_mm() const { return contact_mm_; }

 private:
  enum class Below { none, found, undecided };
  /// Lowest point of the core, on the axis' side of the contact, before the flat moves it aside.
  model::Vec3 core_touching(const model::Vec3& p, const model::Vec3& n) const;
  /// Positions that touch a place where the contact is no single point of the cutter.
  std::vector<model::Vec3> contact_choices(const model::Vec3& p, const model::Vec3& n) const;
  std::vector<model::Vec3> necked_choices(const model::Vec3& p, const model::Vec3& n,
                                          double lean_rad) const;
  bool surely_unreachable_by_tip(const OffsetCell& cell) const;
  bool surely_unreachable_by_hull(const OffsetCell& cell, ContactMemory* memory) const;
  bool surely_unreachable_round(const OffsetCell& cell, double lean_rad) const;
  /// All tips that touch the cell with the cutter's bottom, its wall, or the top of its flutes.
  std::vector<ContactRegion> contact_regions(const OffsetCell& cell, double lean_rad) const;
  /// Whether some point of S is nearer than `limit_mm` to a cutter of such parts with its tip at
  /// `tip`.
  Below comes_below(std::span<const StandingPart> parts, const model::Vec3& tip,
                    double limit_mm) const;

  const SurfaceCells* cells_;
  model::Pose to_own_ = {};
  bool among_others_ = false;
  CutterProfile profile_;
  double allowance_mm_, contact_mm_;
  /// What the cutter is taken to be made of: the endless flutes, or flutes and parts as stated.
  std::vector<StandingPart> parts_;
  bool neck_ = false;            ///< a part above the flutes is narrower than their top
  bool narrower_above_ = false;  ///< or than the endless wall
  bool edge_is_free_ = false;    ///< the flutes' top is as wide as what stands on it
};

/// A lower bound of the signed distance from the points of `box` to the endless cutter standing at
/// `tip`.
inline double standing_bound(const CutterProfile& profile, const model::Vec3& tip,
                             const model::Box3& box) {
  const double dx = std::max({box.low.x - tip.x, 0.0, tip.x - box.high.x});
  const double dy = std::max({box.low.y - tip.y, 0.0, tip.y - box.high.y});
  return open_value(profile, std::sqrt(dx * dx + dy * dy), box.high.z - tip.z);
}

}  // namespace limitgauge::verifier
