#pragma once

#include <optional>
#include <vector>

#include "engine/strategy/levels/level_loops.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// How the tip comes to where a pass of a level begins.
enum class Arrival {
  link,       ///< straight on from the pass before, through what has been cleared
  cut_link,   ///< the same, through standing material
  clear_air,  ///< straight down: nothing stands under the cutter
  standing    ///< down into what this level has to clear
};

/// One loop of a level as it is cut.
struct LevelPass {
  Arrival arrival = Arrival::standing;
  std::vector<FlatPoint> points;  ///< of a closed one the first is repeated at the end
  bool closed = false;
  /// Centre of a helix down to the first point, on the side away from the forbidden region; where
  /// there is room for one.
  std::optional<FlatPoint> helix;
};

struct PassRule {
  CutDirection direction = CutDirection::either;
  double cut_radius_mm = 0, widest_mm = 0;  ///< of the cutter at the tip, and anywhere
  double longest_link_mm = 0;               ///< a longer one takes more time than a retract
  double helix_radius_mm = 0;
};

/// Puts the loops of one level in order: each after those of earlier groups within a spacing of it,
/// among the others the nearest next; open ones from the end that `direction` asks for or the
/// nearer one, closed ones from their nearest point.
std::vector<LevelPass> order_loops(std::vector<std::vector<Isoline>> groups,
                                   const LevelSpace& space, const StockOutline& outline,
                                   const LoopRule& loops, const PassRule& rule);

}  // namespace limitgauge::engine::strategy
