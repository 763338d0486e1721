// The first motion under cutter compensation.
#include <algorithm>

#include "model/base/number_text.h"
#include "model/gcode/cycles/cutter_compensation.h"

namespace limitgauge::model::gcode {
namespace {

/// An entry arc whose chord is this near to square with the radius at its end, as a cosine, has
/// become a straight line.
constexpr double kStraight = 1e-6;
/// As for programmed centres: beyond any machine.
constexpr double kLargestRadiusMm = 1e9;

std::string mm(double value_mm) {
  return six_digits(value_mm) + " mm";
}

}  // namespace

void CutterCompensation::check_entry(const Motion& motion) const {
  const double length_mm = length(frame_.flat(motion.to) - end_mm());
  if (length_mm <= radius_mm_)
    fail(motion,
         "the entry into cutter compensation is " + mm(length_mm) +
             " long in its plane, the cutter's radius " + mm(radius_mm_),
         "an entry longer than the radius");
}

void CutterCompensation::check_width(const Motion& arc, double arc_radius_mm) const {
  if (inside(arc) && arc_radius_mm <= radius_mm_)
    fail(arc,
         "an arc of " + mm(arc_radius_mm) +
             " radius around the inside of which the cutter goes, whose radius is " +
             mm(radius_mm_),
         "an arc wider than the cutter");
}

/// To the side of its end. LinuxCNC keeps no direction for the check of what was cut short: the
/// entry is longer than the radius, and its end may be pulled back to any place beside it.
void CutterCompensation::enter_straight(const Motion& motion) {
  check_entry(motion);
  const PlaneVector end = frame_.flat(motion.to);
  const PlaneVector normal = side_ * quarter_turn(unit(end - end_mm()));
  queue_.starts_at(end_mm());
  beside_mm_ = end + radius_mm_ * normal;
  push_straight(motion, normal, beside_mm_);
}

/// From where the tool is to the side of the programmed end, tangent to the programmed arc there:
/// the centre moves along the radius at the end until both ends are equally far from it.
void CutterCompensation::enter_arc(const Motion& motion) {
  check_entry(motion);
  const PlaneVector start = end_mm(), end = frame_.flat(motion.to);
  const PlaneVector programmed_centre = {motion.centre1, motion.centre2};
  check_width(motion, length(programmed_centre - start));
  const PlaneVector inwards = unit(programmed_centre - end);
  beside_mm_ = end + (inside(motion) ? radius_mm_ : -radius_mm_) * inwards;
  const PlaneVector chord = start - beside_mm_;
  const double cosine = dot(unit(chord), inwards);
  const double reach_mm = length(chord) / 2;
  if (std::abs(cosine) < std::max(kStraight, reach_mm / kLargestRadiusMm))
    fail(motion, "an entry arc that cutter compensation bends into a straight line",
         "an arc that starts away from the tangent beside its end");
  const PlaneVector centre = beside_mm_ + (reach_mm / cosine) * inwards;
  Motion arc = motion;
  arc.centre1 = centre.a;
  arc.centre2 = centre.b;
  push_arc(arc, beside_mm_, sweep_of(start, beside_mm_, centre, arc.turns));
}

}  // namespace limitgauge::model::gcode
