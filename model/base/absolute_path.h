#pragma once

#include <filesystem>

namespace limitgauge::model {

/// `path` seen from the working folder. Throws InputError where that is gone and `path` is
/// relative.
std::filesystem::path absolute_path(const std::filesystem::path& path);

}  // namespace limitgauge::model
