#include "model/gcode/cycles/cutter_compensation_plane.h"

#include <numbers>

#include "model/base/tolerance.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {

double sweep_of(Vec2 from, Vec2 to, Vec2 centre, double turns) {
  const Vec2 start = from - centre, end = to - centre;
  const double full = 2 * std::numbers::pi;
  double sweep = std::atan2(end.y, end.x) - std::atan2(start.y, start.x);
  if (turns > 0) return (sweep <= 0 ? sweep + full : sweep) + (turns - 1) * full;
  if (sweep >= 0) sweep -= full;
  return sweep + (turns + 1) * full;
}

Corner corner_of(Vec2 before, Vec2 after, double side, const CornerRule& rule) {
  // Away from the tool is positive.
  const double turn = -side * std::atan2(cross(before, after), dot(before, after));
  if (std::abs(turn) >= std::numbers::pi - rule.reversal_rad)
    return rule.reversal_is_inner ? Corner::inner : Corner::outer;
  if (std::abs(turn) <= rule.smooth_rad) return Corner::smooth;
  return turn > 0 ? Corner::outer : Corner::inner;
}

std::pair<Vec2, Vec2> outer_corner(Vec2 before, Vec2 after, Vec2 beside, Vec2 to,
                                   double radius_mm) {
  const double cosine = dot(before, after);
  if (cosine < 0) return {beside + radius_mm * before, to - radius_mm * after};
  // Half the turn's tangent, as of an inner corner.
  const double tangent = std::abs(cross(before, after)) / (1 + cosine);
  const Vec2 met = beside + radius_mm * tangent * before;
  return {met, met};
}

Vec2 meet_lines(Vec2 before, Vec2 after, Vec2 beside, double radius_mm) {
  // Half the turn's tangent, exact for a right angle.
  const double tangent = std::abs(cross(before, after)) / (1 + dot(before, after));
  return beside - radius_mm * tangent * before;
}

std::optional<Vec2> meet_line_and_arc(const OffsetArc& arc, Vec2 direction, Vec2 normal,
                                      double height_mm, bool arc_comes_first) {
  const double across = height_mm / arc.radius_mm;
  if (!(std::abs(across) <= 1)) return std::nullopt;
  const double along = std::sqrt(1 - across * across);
  const double later = arc.tool_inside != arc_comes_first ? 1 : -1;
  return arc.centre + arc.radius_mm * (across * normal + later * along * direction);
}

std::optional<Vec2> meet_arcs(const OffsetArc& before, const OffsetArc& after,
                              bool after_is_counter_clockwise) {
  const Vec2 between = after.centre - before.centre;
  const double apart_mm = length(between);
  const double r1 = before.radius_mm, r2 = after.radius_mm;
  // The law of cosines, about the first centre.
  const double along = (r1 * r1 + apart_mm * apart_mm - r2 * r2) / (2 * r1 * apart_mm);
  if (!(std::abs(along) <= 1)) return std::nullopt;
  const double left = before.tool_inside == after_is_counter_clockwise ? 1 : -1;
  const Vec2 axis = unit(between);
  const double across = left * std::sqrt(1 - along * along);
  return before.centre + r1 * (along * axis + across * quarter_turn(axis));
}

}  // namespace limitgauge::model::gcode
