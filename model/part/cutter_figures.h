#pragma once

#include "model/base/tolerance.h"
#include "model/part/cutter.h"

namespace limitgauge::model {

/// The fluted part of any cutter as APT has it (ISO 3592, CUTTER/d,r,e,f,a,b,h): a corner circle
/// between a lower line through the tip and an upper line, turned about the axis. Lengths mm,
/// angles degrees. Circle and lines touch: e and f follow from the rest.
struct SevenFigures {
  double diameter = 0;       ///< d: twice the distance from the axis to where the two lines meet
  double corner_radius = 0;  ///< r
  double centre_radius = 0;  ///< e: from the axis to the corner circle's centre
  double centre_height = 0;  ///< f: from the tip to the corner circle's centre, along the axis
  double lower_angle = 0;    ///< a: of the lower line, from level
  double upper_angle = 0;    ///< b: of the upper line, from the axis; negative leans inwards
  double height = 0;         ///< h: of the flutes

  friend bool operator==(const SevenFigures&, const SevenFigures&) = default;
};

/// The seven figures of a cutter of any type. Flat, ball and bull have a = b = 0, tapers a = 0,
/// drills r = b = 0; no rounding but that of their formulas.
SevenFigures seven_figures(const Cutter& cutter);
/// The cutter with these figures: flat, ball, bull or drill where they are those of one, else apt.
/// Throws std::invalid_argument for what `require_valid` refuses and for e and f further than
/// kCentreAgreementMm from what the others make of them.
Cutter cutter_of(const SevenFigures& figures);
/// Throws std::invalid_argument that names the expected figure where a stated e or f is off.
void require_centre(const Cutter& cutter, const double* stated_e_mm, const double* stated_f_mm);

}  // namespace limitgauge::model
