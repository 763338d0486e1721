#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::simulator {

/// What can be wrong with a move besides the shape that it leaves.
enum class FindingKind {
  rapid_through_stock,  ///< a rapid's cutter met standing material
  shank_in_stock,       ///< shank met material that stood then
  holder_in_stock,
  fixture_touched,    ///< any part of the assembly, on any move
  spindle_stopped,    ///< material removed while the program has the spindle at rest
  feed_missing,       ///< a feed move without a feed rate
  below_flutes,       ///< material stands above the flutes within the cutter's own radius
  steep_descent,      ///< goes down into material more steeply than the cutter can
  cut_while_turning,  ///< rotary axes turn at a feed rate with the flutes in material
  beyond_travel,      ///< outside the stated travel limits
  slight_contact,     ///< a contact of one of the kinds above, no deeper than the stated tolerance
  near_miss           ///< passes material or a fixture within the stated clearance, not touching
};
const char* name(FindingKind kind);  ///< as in result.json: "rapid_through_stock", ...
/// All but near misses and contacts within the tolerance fail a stage.
inline bool fails(FindingKind kind) {
  return kind != FindingKind::near_miss && kind != FindingKind::slight_contact;
}

/// The limit of X, Y or Z (`axis` 0, 1, 2) that something is beyond, as findings name it: "x-",
/// "z+".
std::string travel_limit_name(int axis, bool above);

/// One finding: the worst place of one kind and part on one move.
struct Finding {
  FindingKind kind = FindingKind::rapid_through_stock;
  std::size_t move = 0;    ///< index in the path
  std::uint32_t line = 0;  ///< program line
  model::Vec3 point;       ///< mm
  /// How deep there: a body in material or fixture (a lower bound of the deepest), the tip beyond
  /// the travel, the material that a move with stopped spindle, missing feed or steep descent runs
  /// into. Of a near miss: minus the distance that is left.
  double depth_mm = 0;
  std::string part;     ///< "cutter", "shank", "holder", or a carried body's name
  std::string against;  ///< "stock", the fixture's name, or travel_limit_name()
};

/// What is wrong in the same way over a stretch of the path.
struct FindingGroup {
  FindingKind kind = FindingKind::rapid_through_stock;
  std::string part, against;
  std::uint32_t first_line = 0, last_line = 0;  ///< program lines
  std::size_t first_move = 0, last_move = 0;
  std::size_t count = 0;
  Finding worst;  ///< the deepest, of equal ones the first
};

/// Gathers findings of one kind, part and `against` on moves that follow each other. `findings` are
/// in the order of moves; the groups are in the order of their first moves, then of kinds.
std::vector<FindingGroup> group_findings(std::span<const Finding> findings);

}  // namespace limitgauge::simulator
