#pragma once

#include <string>

namespace limitgauge::linuxcnc {

/// What LinuxCNC's kinematics modules want of its hardware abstraction layer, which is told here by
/// this program: memory, and pins, of which those of numbers may be set.
///
/// The pin's value; a reference that a module reads through whenever it computes. Throws
/// std::out_of_range where no module has asked for such a pin.
double& pin(const std::string& name);

}  // namespace limitgauge::linuxcnc
