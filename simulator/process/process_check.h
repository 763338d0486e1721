#pragma once

#include <vector>

#include "simulator/process/finding.h"
#include "simulator/process/process_limits.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::simulator {

/// Checks `pass` against the stock as it stands at each move: `before` is the stock at the start of
/// the stage. Findings are in the order of moves, then of kinds, then of parts; one a move, kind,
/// part and thing that is met, for its worst place, the worst first; those of carried bodies
/// follow, one a body and thing. The same for any number of threads. Throws std::invalid_argument
/// for limits, a cutter or a path that cannot be, and for a pass of another setup, Interrupted.
///
/// What stands at a move is `before` less all that the moves before it swept. So that a program
/// cannot hide a crash by having it in small pieces, the flutes' contacts are judged against the
/// stock at the start of the series of neighbouring rapids that a rapid is part of
/// (rapid_through_stock; near_miss: of the straight line), of neighbouring moves with the spindle
/// at rest (spindle_stopped), without a feed rate (feed_missing), or down too steeply
/// (steep_descent). What is above the flutes is judged after the move's own flutes have cut, but on
/// the way up, where they come to a place after it, before they have; depths there are those in
/// what stood before the move. A contact deeper than one and a half tolerances is never missed:
/// where a search is given up it is a finding of depth 0 where the move begins.
///
/// - rapid_through_stock: a rapid's flutes in material. One whose own line takes nothing of it is
///   none where the rapid before it was as deep, within a tolerance: it goes where that series has
///   gone. A rapid straight up from where the move before ended is none where the flutes end above
///   all material, nor is one back along the straight line of feed moves before it, as far as that
///   goes back.
/// - shank_in_stock, holder_in_stock: a part as wide as the flutes' top or wider in material.
/// - below_flutes: a part narrower than the flutes' top in material, or, where the stated assembly
///   ends, material above it within the radius of the flutes' top. What stands beside a narrower
///   part is a ledge that the flutes reach under. A wider part has its own finding and not this.
/// - fixture_touched: any part on any move. The depth is that of the fixture's surface in the
///   assembly, which is one body whatever parts it is stated in (ToolBodies::joined: no less than
///   1/√2 of it where the diameter changes), to a fraction of the tolerance; of a part wholly
///   inside the fixture, how deep its middle is in the part plus the least distance from the part
///   to the fixture's surface. Named is the part that is at the place.
/// A carried body in the stock, by the same rule, is a holder_in_stock, and one
/// in a fixture a fixture_touched; its name stands for the part.
///
/// - spindle_stopped: a move with the spindle at rest whose flutes meet material.
/// - feed_missing: any feed move without a feed rate; depth 0 where it meets nothing, and then
///   placed where the move begins.
/// - steep_descent: a feed move on a straight line that goes down more steeply than
///   Cutter::steepest_descent_deg, by more than the rounding of coordinates (1 µm), and meets
///   material. Also one that only slightly does, as one of stairs: descents with no more than the
///   cutter's width of level way between them, over which the way is too steep all in all, where
///   the depths of the last ten add up to more than the tolerance, and so does the move's own in
///   what stood before the stairs.
/// - beyond_travel: the tip ends beyond a limit; `against` is the one by which it is farthest out.
/// - slight_contact: a contact with stock or fixture of a kind above that is shallower than the
///   tolerance but not than a tenth of it, below which a body only slides along.
/// - near_miss: a distance to stock or fixture below `near_miss_mm` where nothing of the move
///   touches that stock or that fixture.
///   Against fixtures: every part on every move, down to contacts too slight to be one (depth 0).
///   Against stock: parts wider than the flutes' top, on every move, likewise. Parts no wider
///   have none: where the flutes fitted they have room. Feed moves' flutes have none: they
///   are to touch. Of rapids' flutes, no place counts that the feed move just before the straight
///   line of rapids, or the one just after it, comes as near to as the rapid does, within a
///   tolerance: it has just been cut, is about to be cut, or is passed as closely on purpose. No
///   near miss is a rapid straight up out of where the move before it ended, as above, nor a rapid
///   that slides along material, within a tolerance: it follows what a cutter has left. Material
///   too thin for a ball of half a tolerance's radius does not count.
///
/// Of a pass that turns its tool as it goes all of this is told by the searches of turns
/// (turn_search.h), against the stock as it stands at each move as above, and with these
/// differences. What is above the flutes of a move that turns is judged against what stands when it
/// gets to a place (trailing_contact.h), but for near misses. Straight lines of rapids are series
/// of neighbouring rapids, steep_descent is judged by a move's own two axes, and straight up is up
/// the tool's axis, while it does not turn. No rapid is known to go back. fixture_touched and
/// slight contacts have the depth at which a part's place lies in the fixture. Near misses of
/// rapids' flutes do not count from the series' first move's start until they are farther away, nor
/// so before its last move's end. A contact deeper than one and a half tolerances is never missed:
/// where a search is given up it is a finding of depth 0 at the tip.
std::vector<Finding> check_process(const StockModel& before, const Pass& pass,
                                   const ProcessLimits& limits, const model::RunControl& control);

/// Whether the flutes of an upright pass are nowhere within `clearance_mm` of `stock`, uncut as it
/// is: no place of it is taken, not even what counts as no contact. False says nothing where they
/// are no more than twice as far away, and of a pass that turns its tool as it goes. Throws
/// Interrupted.
bool keeps_clear(const StockModel& stock, const Pass& pass, double clearance_mm,
                 const model::RunControl& control);

}  // namespace limitgauge::simulator
