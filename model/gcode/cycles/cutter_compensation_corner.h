#pragma once

#include <optional>

#include "model/gcode/cycles/cutter_compensation_plane.h"

namespace limitgauge::model::gcode {

enum class Corner { smooth, outer, inner };

/// What a contour that comes along `before` and goes on along `after` (unit directions) is for a
/// tool on `side` of it (1: left, -1: right), by LinuxCNC's 0.05 radians. A reversal within them is
/// an outer corner unless `reversal_is_inner`.
Corner corner_of(PlaneVector before, PlaneVector after, double side, bool reversal_is_inner);

/// Where two straight paths meet that run beside their lines at `radius_mm`: `beside` is where the
/// first one ends uncut, over the corner.
PlaneVector meet_lines(PlaneVector before, PlaneVector after, PlaneVector beside, double radius_mm);

/// A path at constant distance from an arc.
struct OffsetArc {
  PlaneVector centre;
  double radius_mm = 0;
  bool tool_inside = false;
};

/// Where the straight path that runs along `direction` at `height_mm` over the arc's centre, along
/// `normal`, meets the arc: the later place for an arc that the tool runs inside of, the earlier
/// one outside, or the other way round where the arc comes before the line. Empty where they do not
/// meet.
std::optional<PlaneVector> meet_line_and_arc(const OffsetArc& arc, PlaneVector direction,
                                             PlaneVector normal, double height_mm,
                                             bool arc_comes_first);

/// Where `before` meets `after`, which turns counter-clockwise or not. Empty where they do not
/// meet; their centres differ.
std::optional<PlaneVector> meet_arcs(const OffsetArc& before, const OffsetArc& after,
                                     bool after_is_counter_clockwise);

}  // namespace limitgauge::model::gcode
