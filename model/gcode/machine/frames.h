#pragma once

#include "model/geometry/vec3.h"

namespace limitgauge::model::gcode {

/// Work coordinates to machine coordinates: tip = origin + turn(programmed + G92 offset) + length
/// offset in use - true length of the tool in the spindle. Without a true length (no tool table)
/// the tool is taken to be as long as its own length offset says.
struct Frame {
  Vec3 origin_mm;
  double rotation_deg = 0;  ///< about Z, counter-clockwise seen from above
  Vec3 g92_mm;
  double length_offset_mm = 0;  ///< what G43 added less what the tool truly measures

  Vec3 to_machine(const Vec3& work_mm) const;
  Vec3 to_work(const Vec3& machine_mm) const;
  friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace limitgauge::model::gcode
