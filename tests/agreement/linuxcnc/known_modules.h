#pragma once

#include <random>
#include <vector>

#include "model/machine/kinematics.h"

namespace limitgauge::linuxcnc {

/// How a module is told of its machine, and which machine that is.
struct Case {
  model::Kinematics machine;
  double tool_length_mm = 0;
};

/// A module that is held against model::Kinematics. Joints are X, Y, Z and then `words`.
struct KnownModule {
  const char* name;   ///< of the file, without ending
  int type;           ///< the number of the kinematics that follow the tool's tip
  const char* words;  ///< of the rotary joints, and W where the module has one
  Case (*draw)(std::mt19937_64& random);  ///< sets the pins to a random machine
};

const std::vector<KnownModule>& known_modules();

}  // namespace limitgauge::linuxcnc
