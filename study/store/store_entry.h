#pragma once

#include <optional>
#include <string>

namespace limitgauge::study {

/// `content` as the file of an entry: a line that says of what key it is, how long and with what
/// checksum, and then the content, compressed.
std::string pack_entry(const std::string& content, const std::string& key);
/// The content; nothing where the file is not whole, of another key or of another version.
std::optional<std::string> unpack_entry(const std::string& file, const std::string& key);

}  // namespace limitgauge::study
