#pragma once

#include <filesystem>
#include <string>

namespace limitgauge::model {

/// `path` seen from the working folder. Throws InputError where that is gone and `path` is
/// relative.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// ".obj" of "PART.OBJ": what the ending of a name says, whatever the case of its letters.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace limitgauge::model
