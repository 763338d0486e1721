#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limitgauge::study {

/// Writes a file that is there whole or not at all, whoever else writes, reads or is killed: beside
/// its name first, then renamed. Makes the folders above it. Throws model::ResourceError.
void write_whole(const std::filesystem::path& file, std::string_view bytes);

/// True for the name of what write_whole() has not renamed yet.
bool is_part_file(std::string_view name);

}  // namespace limitgauge::study
