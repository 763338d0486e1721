#include "engine/model/gcode/frames.h"

#include <cmath>
#include <numbers>

namespace limitgauge::model::gcode {

Vec3 turned(const Vec3& v, double degrees) {
  if (degrees == 0) return v;
  const double within = std::remainder(degrees, 360.0);
  if (within == 90) return {-v.y, v.x, v.z};
  if (within == -90) return {v.y, -v.x, v.z};
  if (std::abs(within) == 180) return {-v.x, -v.y, v.z};
  const double angle = within * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  return {v.x * c - v.y * s, v.x * s + v.y * c, v.z};
}

Vec3 Frame::to_machine(const Vec3& work_mm) const {
  return origin_mm + turned(work_mm + g92_mm, rotation_deg) + Vec3{0, 0, length_offset_mm};
}

Vec3 Frame::to_work(const Vec3& machine_mm) const {
  return turned(machine_mm - origin_mm - Vec3{0, 0, length_offset_mm}, -rotation_deg) - g92_mm;
}

}  // namespace limitgauge::model::gcode
