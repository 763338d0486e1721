#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/machine/machine_setup.h"

namespace limitgauge::app {

/// What the command line says of the machine that a program runs on, as text.
struct MachineOptions {
  std::vector<std::string> work_offsets;  ///< `G54=X,Y,Z` or `G54=X,Y,Z,TURN`
  std::string home, second_home;          ///< `X,Y,Z`; empty: not stated
  std::string start;                      ///< `X,Y,Z` of the tip; empty: not stated
  std::filesystem::path tool_table;       ///< LinuxCNC's; empty: none
  std::string control;                    ///< its name; empty: not stated
  std::filesystem::path subprograms;      ///< a folder; empty: none
};

/// The first option that is stated, as `--control`; empty where none is.
std::string stated_option(const MachineOptions& options);
/// `linuxcnc, fanuc, haas, mach3, grbl or siemens`.
std::string control_names();
/// Three numbers as `X,Y,Z`. Throws UsageError that names `option`.
model::Vec3 point_of(const std::string& option, const std::string& text);
/// Throws UsageError for options that say nothing, InputError for a tool table that cannot be read.
model::MachineSetup machine_of(const MachineOptions& options);

}  // namespace limitgauge::app
