#pragma once

#include <filesystem>

#include "model/part/toolpath.h"

namespace limitgauge::reports {

/// The moves of a toolpath.vtp as write_toolpath_vtp writes them: places to the last bit, lines,
/// kinds and feeds. The chords' error, which stands in result.json, is left at zero. Throws
/// model::InputError for a file that cannot be read or is no such toolpath.
model::Toolpath read_toolpath_vtp(const std::filesystem::path& file);

}  // namespace limitgauge::reports
