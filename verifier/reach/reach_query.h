#pragma once

#include "verifier/gate/deviation.h"
#include "verifier/reach/reach_map.h"

namespace limitgauge::verifier {

/// What a search over neighbouring cells keeps from one proof to the next, by cutter.
using ReachMemory = std::vector<ContactMemory>;

/// Whether places and cells of S can be touched by any of several cutters, each of which stands
/// upright in a frame of its own (Reachability::to_own): as the map has proven of
/// the cells that hold them, else by a search for each. All with the same allowance and contact
/// tolerance; sharp edges, whose points have many normals, are always searched.
class ReachQuery {
 public:
  ReachQuery(std::span<const Reachability> searches, const ReachMap& proven)
      : searches_(searches), proven_(proven) {}

  /// A proof that a gouge-free position touches S at the place, where its unit normal is `normal`.
  bool can_be_touched(const SurfacePlace& place, const model::Vec3& normal) const;
  /// The same of a point of a sharp edge with one of its normals.
  bool ridge_can_be_touched(const model::Vec3& p, const model::Vec3& normal) const;
  /// That position, in the cutter's own frame, and whose it is.
  struct Touch {
    std::size_t cutter = 0;
    model::Vec3 tip;
  };
  std::optional<Touch> touch(const SurfacePlace& place, const model::Vec3& normal) const;
  /// Whether the map says of all of a cell what can be touched.
  bool is_mapped(const SurfaceCell& cell) const { return proven_.of(cell) != Reach::undecided; }
  /// Proof that no point of the cell can be touched. False means "not proven".
  bool surely_unreachable(const SurfaceCell& cell, const OffsetCell& offset,
                          ReachMemory* memory = nullptr) const;
  /// The same of any piece of a face, whatever the map says, and of a piece of a sharp edge.
  bool surely_unreachable(const OffsetCell& piece, ReachMemory* memory = nullptr,
                          NormalOf of = NormalOf::face) const;
  bool ridge_surely_unreachable(const OffsetCell& cell, ReachMemory* memory = nullptr) const {
    return surely_unreachable(cell, memory, NormalOf::edge);
  }

  /// Whether one of the cutters has proofs of what it reaches.
  bool any_is_mapped() const;
  /// Whether a cell can be proven to be out of reach at all: each of the cutters has such proofs.
  bool may_prove_unreachable() const;

  std::span<const Reachability> searches() const { return searches_; }

 private:
  std::span<const Reachability> searches_;
  const ReachMap& proven_;
};

}  // namespace limitgauge::verifier
