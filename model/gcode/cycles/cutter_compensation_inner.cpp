// Inner corners of a compensated contour: where the paths beside its pieces meet.
#include "model/gcode/cycles/cutter_compensation.h"
#include "model/gcode/cycles/cutter_compensation_corner.h"

namespace limitgauge::model::gcode {
namespace {

PlaneVector centre_of(const Motion& arc) {
  return {arc.centre1, arc.centre2};
}

/// The path of a compensated arc.
OffsetArc path_of(const Motion& arc, const PlaneFrame& frame, bool tool_inside) {
  return {centre_of(arc), length(frame.flat(arc.to) - centre_of(arc)), tool_inside};
}

constexpr const char* kWiderCorner = "a corner that the cutter fits into";

}  // namespace

PlaneVector CutterCompensation::corner_before_line(const Motion& line, PlaneVector after) const {
  const std::optional<Motion>& arc = queue_.leading_arc();
  if (!arc) return meet_lines(direction(), after, beside_mm_, radius_mm_);
  const OffsetArc path = path_of(*arc, frame_, inside(*arc));
  const double arc_radius_mm = path.radius_mm + (path.tool_inside ? radius_mm_ : -radius_mm_);
  const PlaneVector normal = side_ * quarter_turn(after);
  const double centre_mm = arc_radius_mm * dot(unit(path.centre - end_mm()), normal);
  const auto met = meet_line_and_arc(path, after, normal, radius_mm_ - centre_mm, true);
  if (!met)
    fail(line, "the cutter does not fit between the arc before and this straight move",
         kWiderCorner);
  return *met;
}

PlaneVector CutterCompensation::corner_before_arc(const Motion& arc) const {
  if (const auto& before = queue_.leading_arc()) return corner_of_arcs(*before, arc);
  const double arc_radius_mm = length(centre_of(arc) - frame_.flat(arc.to));
  const bool tool_inside = inside(arc);
  const OffsetArc path = {centre_of(arc), arc_radius_mm + (tool_inside ? -radius_mm_ : radius_mm_),
                          tool_inside};
  const double centre_mm = arc_radius_mm * dot(unit(path.centre - end_mm()), normal());
  const auto met = meet_line_and_arc(path, direction(), normal(), radius_mm_ - centre_mm, false);
  if (!met)
    fail(arc, "the cutter does not fit between the straight move before and this arc",
         kWiderCorner);
  return *met;
}

PlaneVector CutterCompensation::corner_of_arcs(const Motion& before, const Motion& arc) const {
  const OffsetArc first = path_of(before, frame_, inside(before));
  const double arc_radius_mm = length(centre_of(arc) - frame_.flat(arc.to));
  const OffsetArc second = {centre_of(arc),
                            arc_radius_mm + (inside(arc) ? -radius_mm_ : radius_mm_), inside(arc)};
  if (first.centre == second.centre)
    fail(arc, "an inner corner between two arcs of one centre with cutter compensation",
         "arcs about different centres");
  const auto met = meet_arcs(first, second, arc.turns > 0);
  if (!met) fail(arc, "the cutter does not fit between the arc before and this arc", kWiderCorner);
  return *met;
}

}  // namespace limitgauge::model::gcode
