#pragma once

#include <filesystem>
#include <istream>
#include <string>

namespace limitgauge::model {

/// Whether a file stands there that can be read; false too for names that no file can have.
bool is_file(const std::filesystem::path& path);
/// The whole of a file. An InputError names a path that is missing, a directory or unreadable.
std::string read_text_file(const std::filesystem::path& path);
/// The rest of a stream; an InputError for `name` where it breaks.
std::string read_text(std::istream& in, const std::string& name);

}  // namespace limitgauge::model
