#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/base/tolerance.h"
#include "model/geometry/vec3.h"

namespace limitgauge::model {

enum class CutterType { flat, ball, bull, taper, drill, apt };

/// A cylinder of a shank or holder; parts are listed from the tip side up.
struct CylinderPart {
  double diameter_mm = 0;
  double length_mm = 0;
};

/// Flute length of a cutter for which none is stated, as a multiple of its diameter; assumptions
/// say so.
inline constexpr double kDefaultFluteDiameters = 4;

/// A rotating cutter about +Z with its tip at the origin.
///  flat:  cylinder of `diameter_mm`; corner_radius = 0
///  ball:  hemisphere of that diameter, then the cylinder; corner_radius = diameter / 2
///  bull:  cylinder whose bottom edge is rounded by `corner_radius_mm`
///  taper: cone of half angle `taper_angle_deg` rising from a tip of `diameter_mm` whose edge is
///         rounded by `corner_radius_mm`, tangent to the cone: the rounding's centre lies
///         diameter / 2 - corner_radius off the axis, so that corner_radius = diameter / 2 makes a
///         ball tip of that diameter
///  drill: cone rising from the tip by `tip_angle_deg` from level to `diameter_mm`, then the
///         cylinder; corner_radius = 0. A point angle of 118 degrees is a tip angle of 31
///  apt:   the seven-parameter cutter of APT (ISO 3592, CUTTER/d,r,e,f,a,b,h), a convex solid: a
///         bottom that rises from the tip by `tip_angle_deg`, a side that leans outwards by
///         `taper_angle_deg` (inwards where negative), and between them an arc of
///         `corner_radius_mm` tangent to both; `diameter_mm` is twice the radius at which bottom
///         and side would meet, h the flute length; e and f follow from the rest
/// Only the lowest `flute_length_mm` cuts. Above it stand the shank parts, then the holder parts;
/// with an empty shank the fluted part is taken to end at the holder.
struct Cutter {
  std::string id;
  CutterType type = CutterType::ball;
  double diameter_mm = 0;
  double corner_radius_mm = 0;  ///< of a valid cutter the rounding at its tip, whatever its type
  double taper_angle_deg = 0;
  double flute_length_mm = 0;
  std::vector<CylinderPart> shank;
  std::vector<CylinderPart> holder;
  double tip_angle_deg = 0;
  /// How steeply a feed move may go down into material, from level: 90 where the cutter can plunge.
  double steepest_descent_deg = 90;

  double radius_mm() const { return diameter_mm / 2; }
};

/// Greatest radius of the fluted part, in mm: of a taper at the end of its flutes, of an apt cutter
/// whose side leans inwards at its corner.
double largest_radius_mm(const Cutter& cutter);
/// Throws std::invalid_argument naming the figure that makes no cutter (zero diameter, a corner
/// that does not fit, bottom and side that do not meet in a convex body, flutes that end below the
/// side, NaN, ...).
void require_valid(const Cutter& cutter);
/// `ball:D=6`, `flat:D=8`, `bull:D=8,r=1`, `taper:D=1,r=0.5,angle=5`, `drill:D=6,angle=118` (the
/// point angle), `apt:D=10,r=1,a=10,b=-5` (tip and side angle; r, a and b may be left out, e and f
/// may be stated and must agree with the rest within 0.01 mm), with optional `L=` flute length
/// (default: four diameters), `ramp=` steepest descent, `shank=D:L`, `holder=D:L`, repeated from
/// the tip up. Throws InputError with the column in `text`.
Cutter parse_cutter(std::string_view text);
/// The text form that parse_cutter reads back.
std::string to_text(const Cutter& cutter);
const char* name(CutterType type);

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
