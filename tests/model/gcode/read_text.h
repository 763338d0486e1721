#pragma once

#include <sstream>
#include <string>

#include "model/base/error.h"
#include "model/gcode/program.h"

namespace limitgauge::model::test {

inline Program read_text(const std::string& text, const MachineSetup& machine = {}) {
  std::istringstream in(text);
  return read_program(in, "text.ngc", machine);
}

/// What the program's InputError says behind the file's name; "no error" where there is none.
inline std::string error_of(const std::string& text, const MachineSetup& machine = {}) {
  try {
    read_text(text, machine);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(std::string("text.ngc:").size());
  }
  return "no error";
}

/// Where the program's last motion ends.
inline Vec3 end_of_text(const std::string& text, const MachineSetup& machine = {}) {
  return read_text(text, machine).motions.back().to;
}

/// Whether one of the program's assumptions holds `part`.
inline bool assumes(const Program& program, const std::string& part) {
  for (const std::string& line : program.assumed) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

inline MachineSetup fresh_machine() {
  MachineSetup machine;
  machine.assume_fresh_machine = true;
  return machine;
}

}  // namespace limitgauge::model::test
