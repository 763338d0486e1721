#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace limitgauge::model {

/// Writes `file` through `write`. Throws ResourceError naming the file where that fails, the disk
/// being full among others.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// Writes `bytes` as `file`; errors as above.
void write_file(const std::filesystem::path& file, std::string_view bytes);
/// Makes `folder` with its parents. Throws ResourceError.
void make_folder(const std::filesystem::path& folder);

/// Writes a file that is there whole or not at all, whoever else writes, reads or is killed: beside
/// its name first, then renamed. Makes the folders above it. Throws ResourceError.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);
/// True for the name of what write_whole_file() has not renamed yet.
bool is_part_file(std::string_view name);

}  // namespace limitgauge::model
