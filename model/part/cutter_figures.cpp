#include "model/part/cutter_figures.h"

#include <cmath>
#include <stdexcept>

#include "model/base/angle.h"
#include "model/base/number_text.h"

namespace limitgauge::model {
namespace {

/// The circle that touches both lines lies this way from their meeting: half the sum of the inward
/// normals, as long as makes it r from each.
void place_corner(SevenFigures& c) {
  const double a = radians(c.lower_angle), b = radians(c.upper_angle);
  const double meets_mm = c.diameter / 2, r_mm = c.corner_radius, share = 1 + std::sin(a + b);
  c.centre_radius = meets_mm - r_mm * (std::sin(a) + std::cos(b)) / share;
  c.centre_height = meets_mm * std::tan(a) + r_mm * (std::cos(a) + std::sin(b)) / share;
}

/// What a taper's diameter is: of the tip, not of where the lines meet.
double meeting_diameter_mm(const Cutter& taper) {
  const double angle = radians(taper.taper_angle_deg), r_mm = taper.corner_radius_mm;
  return 2 * (taper.radius_mm() - r_mm + r_mm * (1 - std::sin(angle)) / std::cos(angle));
}

CutterType type_of(const SevenFigures& c) {
  if (c.upper_angle == 0 && c.lower_angle == 0) {
    if (c.corner_radius == 0) return CutterType::flat;
    return c.corner_radius == c.diameter / 2 ? CutterType::ball : CutterType::bull;
  }
  const bool pointed = c.upper_angle == 0 && c.corner_radius == 0;
  return pointed ? CutterType::drill : CutterType::apt;
}

void require_near(const double* stated_mm, double follows_mm, const char* figure) {
  if (stated_mm == nullptr || std::abs(*stated_mm - follows_mm) <= kCentreAgreementMm) return;
  throw std::invalid_argument(std::string(figure) + " is " + shortest(*stated_mm) +
                              ", but the other figures make it " + shortest(follows_mm));
}

}  // namespace

SevenFigures seven_figures(const Cutter& cutter) {
  SevenFigures c;
  c.diameter = cutter.diameter_mm;
  c.corner_radius = c.centre_height = cutter.corner_radius_mm;
  c.centre_radius = cutter.radius_mm() - cutter.corner_radius_mm;
  c.lower_angle = cutter.tip_angle_deg;
  c.upper_angle = cutter.taper_angle_deg;
  c.height = cutter.flute_length_mm;
  if (cutter.type == CutterType::taper) c.diameter = meeting_diameter_mm(cutter);
  if (cutter.type == CutterType::drill)
    c.centre_height = cutter.radius_mm() * std::tan(radians(cutter.tip_angle_deg));
  if (cutter.type == CutterType::apt) place_corner(c);
  return c;
}

void require_centre(const Cutter& cutter, const double* stated_e_mm, const double* stated_f_mm) {
  const SevenFigures c = seven_figures(cutter);
  require_near(stated_e_mm, c.centre_radius, "e");
  require_near(stated_f_mm, c.centre_height, "f");
}

Cutter cutter_of(const SevenFigures& figures) {
  Cutter cutter;
  cutter.type = type_of(figures);
  cutter.diameter_mm = figures.diameter;
  cutter.corner_radius_mm = figures.corner_radius;
  cutter.tip_angle_deg = figures.lower_angle;
  cutter.taper_angle_deg = figures.upper_angle;
  cutter.flute_length_mm = figures.height;
  require_valid(cutter);
  require_centre(cutter, &figures.centre_radius, &figures.centre_height);
  return cutter;
}

}  // namespace limitgauge::model
