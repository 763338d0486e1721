#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace limitgauge::app {

/// Writes `file` through `write`. Throws ResourceError naming the file where that fails, the disk
/// being full among others.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// Makes `folder` with its parents. Throws ResourceError.
void make_folder(const std::filesystem::path& folder);

}  // namespace limitgauge::app
