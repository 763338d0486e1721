#pragma once

#include "model/gcode/program.h"
#include "model/geometry/arc.h"

namespace limitgauge::model {

/// What the arc `motion` goes along from `start`, in the frame of the program. One that ends within
/// 1e-6 radians beyond its start is a full turn.
Arc arc_of(const Motion& motion, const Vec3& start);

}  // namespace limitgauge::model
