#pragma once

#include <optional>
#include <vector>

#include "engine/model/fixture.h"
#include "simulator/finding.h"
#include "simulator/stock_model.h"

namespace limitgauge::simulator {

/// What a process is checked against.
struct ProcessLimits {
  double tolerance_mm = 0;  ///< contacts shallower than this are none; > 0
  double near_miss_mm = 0;  ///< passing stock or fixture within this is a near miss; 0: not looked
                            ///< for
  std::optional<model::Box3> travel_mm;  ///< of the tip, infinite where an axis has no limit
  std::vector<model::Fixture> fixtures;
};

/// Checks `pass` against the stock as it stands at each move: `before` is the stock at the start of
/// the stage. Findings are in the order of moves, then of kinds, then of parts; one a move, kind
/// and part, for its worst place. The same for any number of threads. Throws std::invalid_argument
/// for limits, a cutter or a path that cannot be, Interrupted.
///
/// What stands at a move is `before` less all that the moves before it swept. So that a program
/// cannot hide a crash by having it in small pieces, the cutter's contacts are judged against
/// the stock at the start of
///  - the straight line of rapids that a rapid is part of (rapid_through_stock, near_miss);
///  - the series of neighbouring moves with the spindle at rest (spindle_stopped), without a feed
///    rate (feed_missing) or down too steeply (steep_descent).
/// What is above the flutes is judged after the move's own flutes have cut.
///
/// rapid_through_stock  A rapid's flutes in material. A rapid straight up from where the move
/// before
///   ended is none where the flutes end above all material.
/// shank_in_stock, holder_in_stock  A part as wide as the flutes or wider in material.
/// below_flutes  Material stands above the flutes' top within their largest radius, at a height
///   where the stated assembly is narrower or ends. A narrower part that meets material is found by
///   this and not as shank_in_stock; a wider one has its own finding and not this.
/// fixture_touched  Any part on any move. The depth is that of the fixture's surface in the body,
///   exact to a fraction of the tolerance; of a body wholly inside the fixture, how deep its middle
///   is in the body plus the least distance from the body to the fixture's surface.
/// spindle_stopped  A move with the spindle at rest whose flutes meet material.
/// feed_missing  Any feed move without a feed rate; depth 0 where it meets nothing, and then placed
///   where the move begins.
/// steep_descent  A feed move that goes down more steeply than Cutter::steepest_descent_deg, by
/// more
///   than the rounding of coordinates (1 µm), and meets material.
/// beyond_travel  The tip ends beyond a limit; `against` is the limit by which it is farthest out.
/// near_miss  A distance to stock or fixture below `near_miss_mm` where nothing of the move touches
///   that stock or that fixture.
///   Against fixtures: every part on every move, down to contacts too shallow to be one (depth 0).
///   Against stock: parts wider than the flutes, on every move, likewise. Parts no wider than the
///   flutes have none: where the flutes fitted they have room. Feed moves' flutes have none: they
///   are to touch. Of rapids' flutes, no place counts that the feed move just before the straight
///   line of rapids, or the one just after it, comes as near to as the rapid does, within a
///   tolerance: it is what has just been cut, is about to be cut, or is passed as closely on
///   purpose. Nor does a rapid that slides along material, within a tolerance: it follows what this
///   or an earlier cutter has cut. Material too thin for a ball of half a tolerance's radius does
///   not count.
std::vector<Finding> check_process(const StockModel& before, const Pass& pass,
                                   const ProcessLimits& limits, const model::RunControl& control);

}  // namespace limitgauge::simulator
