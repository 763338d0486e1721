#pragma once

#include <span>
#include <string_view>

namespace limitgauge::app {

/// A line of what help and man page say beyond the options: a name and what it means.
struct UsageNote {
  std::string_view name, text;
};

std::span<const UsageNote> exit_code_notes();
std::span<const UsageNote> file_notes();
std::span<const UsageNote> environment_notes();
/// Command lines with what they do.
std::span<const UsageNote> example_notes();

}  // namespace limitgauge::app
