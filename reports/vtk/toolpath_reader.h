#pragma once

#include <filesystem>
#include <optional>

#include "model/part/toolpath.h"

namespace limitgauge::reports {

/// A path, and how the tool stands along it where it turns.
struct ToolpathRead {
  model::Toolpath path;
  std::optional<model::ToolAxes> axes;
};
/// The moves of a toolpath.vtp as write_toolpath_vtp writes them: places and axes to the last bit,
/// lines, kinds and feeds. The chords' error, which stands in result.json, is left at zero. Throws
/// model::InputError for a file that cannot be read or is no such toolpath.
ToolpathRead read_toolpath_vtp(const std::filesystem::path& file);

}  // namespace limitgauge::reports
