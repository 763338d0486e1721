#pragma once

#include <filesystem>
#include <string>

#include "model/gcode/flow/flow.h"

namespace limitgauge::model::gcode {

/// Files of `folder` by program number: the only regular file there whose name, but for its
/// extension, is the number, with or without O and leading zeros (`O0100.nc`, `100`). Links that
/// lead out of the folder are not followed. Throws InputError where two files fit, or one is
/// unreadable. Empty for an empty folder: nothing is looked for then.
FindSubprogram subprograms_in(const std::filesystem::path& folder);

}  // namespace limitgauge::model::gcode
