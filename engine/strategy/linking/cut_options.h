#pragma once

#include <optional>

namespace limitgauge::engine::strategy {

enum class Strategy { contour, zigzag, steep_shallow, rest };
/// How rows follow each other: to and fro, or each cut the same way after a retract or link.
enum class RowPattern { zigzag, one_way };
/// Which side of the cutter the material is on, for a spindle that turns clockwise seen from above:
/// climb leaves the part on the right of the cutter's way.
enum class CutDirection { either, climb, conventional };
/// How a cutter gets down into standing material.
enum class Entry { plunge, ramp, helix };

/// How one stage is to be cut; lengths mm, angles degrees, feeds mm/min.
struct CutOptions {
  Strategy strategy = Strategy::zigzag;
  RowPattern pattern = RowPattern::zigzag;
  CutDirection direction = CutDirection::either;
  /// Level distance of a contour, distance of the drive planes of a zigzag; largest one where
  /// `scallop_mm` is given.
  double step_mm = 0;
  /// Largest cusp that may stand between neighbouring passes, along the normal of the surface:
  /// rows come closer where the cutter and the surface ask for it.
  std::optional<double> scallop_mm;
  /// Direction of the rows from +X, counter-clockwise; 90: drive planes perpendicular to X.
  double angle_deg = 90;
  /// steep_shallow: slope of the surface from which contours cut it, from the horizontal.
  double steep_angle_deg = 45;
  /// steep_shallow and rest: how far the passes of a region reach beyond it; empty: two steps.
  std::optional<double> overlap_mm;
  double overlap_or_default_mm() const { return overlap_mm.value_or(2 * step_mm); }
  bool boundary_pass = false;  ///< a pass along the outline of the part after the rows
  double tolerance_mm = 0;  ///< the path may leave the exact cutter location surface by this much
  double feed_mm_min = 0, plunge_feed_mm_min = 0, link_feed_mm_min = 0;
  Entry entry = Entry::ramp;
  double ramp_angle_deg = 3;  ///< of ramps and helices, from the horizontal
};

}  // namespace limitgauge::engine::strategy
