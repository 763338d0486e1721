#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "model/part/toolpath.h"
#include "simulator/sweep/sweep_order.h"
#include "simulator/sweep/swept_distance.h"
#include "simulator/sweep/turning/turning_moves.h"

namespace limitgauge::simulator {

using model::Pass;

/// Throws std::invalid_argument for a pass that cannot be: no path, a coordinate that is not
/// finite, 2^32 moves and more, axes that are none (model::require_axes).
void require_path(const Pass& pass);

/// The move nearest to a point and the swept distance to it.
struct NearestMove {
  std::uint32_t slot = 0;
  SweptSample at;
};

/// A ball's move that is nearest to the middle of a cube, and where all others are to lose against
/// it: CapsuleNarrowing says how.
struct NearestCapsule {
  model::Vec3 middle;
  double half_edge = 0;
  model::Vec3 from_foot;  ///< mm, from the way of the ball's centre to the middle
};

/// All moves of a pass in a bounding-box tree over their tip positions. Moves are addressed by
/// slot, their place in the tree's order. All places are in the frame of the pass's own path, in
/// which its cutter stands along +Z, or as the pass's axes have it: the pass's pose is
/// SweepIndex's.
///
/// The distance to a move that turns its tool is not convex: what is worked out from planes under
/// it lowers them by sag(), which is 0 of all other moves. A slot may then be a part of a move, and
/// there may be more of them than moves.
class SweepTree {
 public:
  /// Throws std::invalid_argument for a cutter that cannot be and as `require_path` does,
  /// Interrupted when told to stop. Takes 144 bytes a move, 36 more while it works; where
  /// the tool turns some 400 for each part of a move, and 100 more.
  explicit SweepTree(const Pass& pass, const model::RunControl& control = {});

  /// The move of least swept distance at `p` among those with path index below `end`, if that
  /// distance is below `bound`. Of several equal ones the first found, whose order is fixed.
  std::optional<NearestMove> nearest(
      const model::Vec3& p, double bound,
      std::uint32_t end = std::numeric_limits<std::uint32_t>::max()) const;
  /// The least path index of the moves whose swept distance at `p` is below `bound`.
  std::optional<std::uint32_t> first_below(const model::Vec3& p, double bound) const;
  /// Appends the slots of all moves that may come within `limit` of `p`.
  void gather(const model::Vec3& p, double limit, std::vector<std::uint32_t>& slots) const;

  /// Appends the slots of all ball moves that may be nearest somewhere in a cube below all tops;
  /// some of those that are not are left out.
  void gather_rivals(const NearestCapsule& nearest, std::vector<std::uint32_t>& slots) const;
  /// Below this height a ball's top does not matter for any move.
  double below_tops_mm() const;

  SweptSample distance(std::uint32_t slot, const model::Vec3& p) const {
    return turns_ ? *turning_distance(profile_, turns_->move(slot), p)
                  : swept_distance(profile_, moves_[slot], p);
  }
  /// The same where it is below `bound`, else something that is not. Of turning moves it may be
  /// `within_mm` too large.
  SweptSample distance_below(std::uint32_t slot, const model::Vec3& p, double bound,
                             double within_mm = 0) const;
  /// True where a quick look shows that the distance is not below `bound`.
  bool cannot_be_below(std::uint32_t slot, const model::Vec3& p, double bound) const {
    return turns_ ? simulator::cannot_be_below(profile_, turns_->move(slot), p, bound)
                  : simulator::cannot_be_below(profile_, moves_[slot], p, bound);
  }
  /// As those of swept_distance.h and turning_move.h, `at` being distance(slot, p).
  double sag(std::uint32_t slot, const model::Vec3& p, const SweptSample& at, double reach) const {
    return turns_ ? turning_sag(profile_, turns_->move(slot), p, at, reach) : 0.0;
  }
  double curvature_bound(std::uint32_t slot, const model::Vec3& p, const SweptSample& at,
                         double reach) const;
  double outside_bound(std::uint32_t slot, const model::Vec3& p, const SweptSample& at,
                       const model::Vec3& half) const;
  /// The distance to a convex body that the move fills and that is as near to p as it: the whole
  /// move, or the cutter as it stands at the time of `at`. At another place.
  SweptSample convex_part(std::uint32_t slot, const SweptSample& at, const model::Vec3& p) const {
    return turns_ ? standing_distance(profile_, turns_->move(slot), p, at.t) : distance(slot, p);
  }
  /// Whether the pass turns its tool as it goes.
  bool turns() const { return turns_.has_value(); }
  const CutterProfile& profile() const { return profile_; }
  const SweptMove& move(std::uint32_t slot) const { return moves_[slot]; }
  std::size_t size() const { return moves_.size(); }
  std::size_t memory_bytes() const;

 private:
  struct Node {
    model::Box3 tips;
    std::uint32_t first = 0;  // first slot of a leaf, or the first of two child nodes
    std::uint32_t count = 0;  // moves of a leaf, 0 for an inner node
    std::uint32_t least_index = 0;
  };
  void set_leaf(Node& node, const SweepOrder::Node& from) const;
  void add_children(Node& node) const;
  template <class Skip>
  void gather_unless(const Skip& skip, std::vector<std::uint32_t>& slots) const;
  double lower_bound(const Node& node, const model::Vec3& p) const;
  void build(const model::Toolpath& path, std::span<const std::uint32_t> of_move,
             const SweepOrder& order, const model::RunControl& control);
  void add_turning(const TurningParts& parts, const SweepOrder& order,
                   const model::RunControl& control);

  CutterProfile profile_;
  std::vector<SweptMove> moves_;
  std::vector<Node> nodes_;
  std::optional<TurningMoves> turns_;
  std::vector<TurningMoves::Node> turning_nodes_;  // of turning moves, one for each node
};

}  // namespace limitgauge::simulator
