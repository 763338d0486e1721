#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace limitgauge::app {

/// "4G", "500 MiB", "1.5T" or a plain number of bytes; letters count by 1024. Nothing for another
/// text.
std::optional<std::uint64_t> bytes_of_text(const std::string& text);

}  // namespace limitgauge::app
