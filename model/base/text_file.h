#pragma once

#include <filesystem>
#include <istream>
#include <string>

namespace limitgauge::model {

/// Whether a file stands there that can be read; false too for names that no file can have.
bool is_file(const std::filesystem::path& path);
/// An InputError names a path that is missing, a directory, a pipe, a socket or a device: of these,
/// some never begin and some never end.
void require_file(const std::filesystem::path& path);
/// The whole of a file, or of a pipe that somebody writes into. An InputError names a path that is
/// anything else or unreadable.
std::string read_text_file(const std::filesystem::path& path);
/// The rest of a stream; an InputError for `name` where it breaks.
std::string read_text(std::istream& in, const std::string& name);

}  // namespace limitgauge::model
