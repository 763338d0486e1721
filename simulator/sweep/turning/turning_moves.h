#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "model/part/toolpath.h"
#include "simulator/sweep/turning/turning_move.h"

namespace limitgauge::simulator {

/// A pass that turns its tool as it goes with its long turns cut into parts (PROOFS.md, P10), and
/// the place in the path of the move that each is of. What is swept stays the same.
struct TurningParts {
  explicit TurningParts(const model::Pass& pass);

  model::Toolpath path;  ///< places alone
  model::ToolAxes axes;
  std::vector<std::uint32_t> of_move;
};

/// The moves of a pass that turns its tool as it goes, in the order of a tree's slots, and what the
/// nodes of that tree need to bound the distance to all moves below them (PROOFS.md, P11).
class TurningMoves {
 public:
  TurningMoves(const TurningParts& parts, const CutterProfile& profile,
               std::span<const std::uint32_t> order, const model::RunControl& control);

  const TurningMove& move(std::uint32_t slot) const { return moves_[slot]; }

  /// How the tool stands in all moves of a node, and where its core is then.
  struct Node {
    model::Box3 cores;
    model::Vec3 axis{0, 0, 1};
    double cone_rad = 0;  ///< no axis is farther from that one
  };
  Node leaf(std::uint32_t first, std::uint32_t count) const;
  static Node both(const Node& a, const Node& b);
  /// A lower bound of the distance to every move of the node.
  double lower_bound(const CutterProfile& profile, const Node& node, const model::Vec3& p) const;

  std::size_t memory_bytes() const { return moves_.capacity() * sizeof(TurningMove); }

 private:
  std::vector<TurningMove> moves_;
  double core_mm_ = 0;
  double size_mm_ = 0;  ///< no place of the cutter is farther from its core
};

}  // namespace limitgauge::simulator
