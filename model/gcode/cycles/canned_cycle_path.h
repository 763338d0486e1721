#pragma once

#include <array>
#include <vector>

#include "model/gcode/program.h"
#include "model/gcode/read/arc.h"

namespace limitgauge::model::gcode {

/// The canned cycles by their G codes in tenths.
enum class Cycle {
  chip_breaking = 730,
  left_tapping = 740,
  drilling = 810,
  drilling_dwell = 820,
  pecking = 830,
  tapping = 840,
  boring = 850,
  boring_stop = 860,
  back_boring = 870,
  boring_by_hand = 880,
  boring_dwell = 890
};

/// One motion of a cycle, in the active work frame.
struct CycleMove {
  MotionKind kind = MotionKind::rapid;  ///< never an arc
  Vec3 to_mm;
  bool spindle_stopped = false;  ///< as by G86 and G87 while they withdraw
  /// The axes that stand where the program put them absolutely, and not relative to where the block
  /// found them.
  std::array<bool, 3> stated{};
};

/// A block of a canned cycle, its words resolved: absolute levels along the tool axis (the plane's
/// perpendicular one), places in the plane's own two axes, mm.
struct CycleGeometry {
  Cycle cycle = Cycle::drilling;
  ArcPlane plane = ArcPlane::xy;
  Vec3 start_mm;
  bool lifts_first = false;  ///< to `r_mm` before it moves across
  /// At whatever level, and to `r_mm` then, as Fanuc and Haas.
  bool goes_across_as_it_stands = false;
  std::vector<Vec2> holes_mm;  ///< one after the other
  double r_mm = 0, bottom_mm = 0;
  double return_mm = 0;          ///< where each hole ends
  bool feeds_to_r = false;       ///< out of a tap or a G89 to R only, as Fanuc and Haas
  double middle_mm = 0;          ///< G87: top of the counterbore
  Vec2 aside_mm{};               ///< G87: from the hole to where the boring bar fits through
  std::vector<double> pecks_mm;  ///< G73, G83: levels drilled before the bottom, falling
  std::array<bool, 3> stated{};  ///< axes that the block places absolutely
};

/// How far G73 withdraws after each peck, and how far above the last one G83's rapid ends:
/// LinuxCNC's 0.010 inch.
inline constexpr double kPeckClearanceMm = 0.254;

/// The motions, in LinuxCNC's order; a rapid that goes nowhere is kept.
std::vector<CycleMove> cycle_moves(const CycleGeometry& geometry);
/// The number of motions of one hole, its approach included, at most.
std::size_t most_moves_per_hole(const CycleGeometry& geometry);

}  // namespace limitgauge::model::gcode
