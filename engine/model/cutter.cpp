#include "engine/model/cutter.h"

#include <cmath>
#include <stdexcept>

#include "engine/model/angle.h"

namespace limitgauge::model {
namespace {

void require_positive(double value, const char* figure) {
  if (!std::isfinite(value) || value <= 0)
    throw std::invalid_argument(std::string(figure) + " must be greater than 0");
}

void require_parts(const std::vector<CylinderPart>& parts, const std::string& what) {
  for (const CylinderPart& part : parts) {
    require_positive(part.diameter_mm, (what + " diameter").c_str());
    require_positive(part.length_mm, (what + " length").c_str());
  }
}

/// Height above the tip at which the rounded bottom edge ends.
double corner_height_mm(const Cutter& cutter) {
  const double angle = radians(cutter.taper_angle_deg);
  return cutter.corner_radius_mm * (cutter.type == CutterType::taper ? 1 - std::sin(angle) : 1);
}

void require_corner_radius(const Cutter& cutter) {
  const double r_mm = cutter.corner_radius_mm;
  if (!std::isfinite(r_mm) || r_mm < 0)
    throw std::invalid_argument("corner radius must not be negative");
  if (r_mm > cutter.radius_mm())
    throw std::invalid_argument("corner radius must not exceed half the diameter");
  if (cutter.type == CutterType::flat && r_mm != 0)
    throw std::invalid_argument("corner radius of a flat cutter must be 0");
  if (cutter.type == CutterType::ball && r_mm != cutter.radius_mm())
    throw std::invalid_argument("corner radius of a ball cutter must be half its diameter");
  if (cutter.type == CutterType::bull && r_mm == 0)
    throw std::invalid_argument("corner radius of a bull cutter must be greater than 0");
}

void require_angle(const Cutter& cutter) {
  const double angle_deg = cutter.taper_angle_deg;
  if (cutter.type == CutterType::taper && !(angle_deg > 0 && angle_deg < 90))
    throw std::invalid_argument("taper angle must lie between 0 and 90 degrees");
  if (cutter.type != CutterType::taper && angle_deg != 0)
    throw std::invalid_argument("taper angle of a cutter that is no taper must be 0");
}

}  // namespace

double largest_radius_mm(const Cutter& cutter) {
  if (cutter.type != CutterType::taper) return cutter.radius_mm();
  const double angle = radians(cutter.taper_angle_deg);
  const double r_mm = cutter.corner_radius_mm;
  const double tangent_radius_mm = cutter.radius_mm() - r_mm + r_mm * std::cos(angle);
  return tangent_radius_mm + (cutter.flute_length_mm - corner_height_mm(cutter)) * std::tan(angle);
}

void require_valid(const Cutter& cutter) {
  require_positive(cutter.diameter_mm, "diameter");
  require_angle(cutter);
  require_corner_radius(cutter);
  require_positive(cutter.flute_length_mm, "flute length");
  if (cutter.flute_length_mm < corner_height_mm(cutter))
    throw std::invalid_argument("flute length must reach to the end of the corner radius");
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

}  // namespace limitgauge::model
