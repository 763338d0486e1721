#include "model/part/cutter.h"

#include <cmath>
#include <stdexcept>

#include "model/base/angle.h"
#include "model/base/coordinate_limit.h"
#include "model/base/tolerance.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

void require_positive(double value, const char* figure) {
  if (!std::isfinite(value) || value <= 0)
    throw std::invalid_argument(std::string(figure) + " must be greater than 0");
  if (!is_near(value))
    throw std::invalid_argument(std::string(figure) + " is " + shortest(value) +
                                " mm; lengths may be " + kFarthestExpected);
  if (!is_length(value))
    throw std::invalid_argument(std::string(figure) + " is " + shortest(value) + " mm; expected " +
                                kLengthExpected);
}

void require_parts(const std::vector<CylinderPart>& parts, const std::string& what) {
  for (const CylinderPart& part : parts) {
    require_positive(part.diameter_mm, (what + " diameter").c_str());
    require_positive(part.length_mm, (what + " length").c_str());
  }
}

bool has_tip_angle(CutterType type) {
  return type == CutterType::drill || type == CutterType::apt;
}

/// Height above the tip at which the rounded bottom edge ends and the side begins.
double side_begins_mm(const SevenFigures& c) {
  return c.centre_height - c.corner_radius * std::sin(radians(c.upper_angle));
}

double top_radius_mm(const SevenFigures& c) {
  const double angle = radians(c.upper_angle);
  return c.centre_radius + c.corner_radius * std::cos(angle) +
         (c.height - side_begins_mm(c)) * std::tan(angle);
}

void require_corner_radius(const Cutter& cutter) {
  const double r_mm = cutter.corner_radius_mm;
  if (!std::isfinite(r_mm) || r_mm < 0)
    throw std::invalid_argument("corner radius must not be negative");
  if (cutter.type != CutterType::apt && r_mm > cutter.radius_mm())
    throw std::invalid_argument("corner radius must not exceed half the diameter");
  if (cutter.type == CutterType::flat && r_mm != 0)
    throw std::invalid_argument("corner radius of a flat cutter must be 0");
  if (cutter.type == CutterType::drill && r_mm != 0)
    throw std::invalid_argument("corner radius of a drill must be 0");
  if (cutter.type == CutterType::ball && r_mm != cutter.radius_mm())
    throw std::invalid_argument("corner radius of a ball cutter must be half its diameter");
  if (cutter.type == CutterType::bull && r_mm == 0)
    throw std::invalid_argument("corner radius of a bull cutter must be greater than 0");
}

void require_tip_angle(const Cutter& cutter) {
  const double angle_deg = cutter.tip_angle_deg;
  if (cutter.type == CutterType::drill && !(angle_deg > 0 && angle_deg < 90))
    throw std::invalid_argument("point angle must lie between 0 and 180 degrees");
  if (cutter.type == CutterType::apt && !(angle_deg >= 0 && angle_deg < 90))
    throw std::invalid_argument("tip angle must be at least 0 and less than 90 degrees");
  if (!has_tip_angle(cutter.type) && angle_deg != 0)
    throw std::invalid_argument("tip angle of a cutter that is neither drill nor apt must be 0");
}

void require_side_angle(const Cutter& cutter) {
  const double angle_deg = cutter.taper_angle_deg;
  if (cutter.type == CutterType::taper && !(angle_deg > 0 && angle_deg < 90))
    throw std::invalid_argument("taper angle must lie between 0 and 90 degrees");
  if (cutter.type == CutterType::apt && !(angle_deg > -90 && angle_deg < 90))
    throw std::invalid_argument("side angle must lie between -90 and 90 degrees");
  if (cutter.type != CutterType::taper && cutter.type != CutterType::apt && angle_deg != 0)
    throw std::invalid_argument("taper angle of a cutter that is no taper must be 0");
  if (!(cutter.tip_angle_deg + angle_deg < 90))
    throw std::invalid_argument(
        "side angle and tip angle must make less than 90 degrees: bottom and side do not meet in a "
        "convex body");
}

/// Bottom, corner and side one after the other from the tip up, each where it ends before the next.
void require_outline(const Cutter& cutter) {
  const SevenFigures c = seven_figures(cutter);
  if (!std::isfinite(c.centre_radius) || !std::isfinite(c.centre_height))
    throw std::invalid_argument("side angle and tip angle make no figures that can be worked with");
  const double reach_mm = c.centre_radius + c.corner_radius * std::sin(radians(c.lower_angle));
  if (reach_mm < -kOnAxisMm)
    throw std::invalid_argument("corner radius does not fit between the axis and the side");
  require_positive(cutter.flute_length_mm, "flute length");
  const bool pointed = cutter.type == CutterType::drill;
  if (cutter.flute_length_mm < side_begins_mm(c))
    throw std::invalid_argument(pointed
                                    ? "flute length must reach to the end of the point"
                                    : "flute length must reach to the end of the corner radius");
  if (!(top_radius_mm(c) >= -kOnAxisMm))
    throw std::invalid_argument("side angle closes the side below the end of the flutes");
}

void require_descent(const Cutter& cutter) {
  if (!(cutter.steepest_descent_deg >= 0 && cutter.steepest_descent_deg <= 90))
    throw std::invalid_argument("steepest descent must lie between 0 and 90 degrees");
}

}  // namespace

double largest_radius_mm(const Cutter& cutter) {
  const SevenFigures c = seven_figures(cutter);
  if (c.upper_angle > 0) return top_radius_mm(c);
  // An upright side, or one that leans inwards: the corner reaches furthest.
  return cutter.type == CutterType::apt ? c.centre_radius + c.corner_radius : cutter.radius_mm();
}

void require_valid(const Cutter& cutter) {
  require_positive(cutter.diameter_mm, "diameter");
  require_tip_angle(cutter);
  require_side_angle(cutter);
  require_corner_radius(cutter);
  require_outline(cutter);
  require_descent(cutter);
  require_parts(cutter.shank, "shank");
  require_parts(cutter.holder, "holder");
}

const char* name(CutterType type) {
  switch (type) {
    case CutterType::flat:
      return "flat";
    case CutterType::ball:
      return "ball";
    case CutterType::bull:
      return "bull";
    case CutterType::taper:
      return "taper";
    case CutterType::drill:
      return "drill";
    case CutterType::apt:
      break;
  }
  return "apt";
}

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
