#include "model/gcode/machine/frames.h"

#include "model/base/angle.h"

namespace limitgauge::model::gcode {

Vec3 Frame::to_machine(const Vec3& work_mm) const {
  return origin_mm + turned(work_mm + g92_mm, rotation_deg) + Vec3{0, 0, length_offset_mm};
}

Vec3 Frame::to_work(const Vec3& machine_mm) const {
  return turned(machine_mm - origin_mm - Vec3{0, 0, length_offset_mm}, -rotation_deg) - g92_mm;
}

}  // namespace limitgauge::model::gcode
