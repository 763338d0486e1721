#include "model/gcode/feed_text.h"

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "model/base/number_text.h"

namespace limitgauge::model {

std::string feed_text(float feed_mm_min) {
  // Shortest digits of the float first; they could round twice on their way through a double.
  std::array<char, 64> digits{};
  const auto shortest_end = std::to_chars(digits.data(), digits.data() + digits.size(), feed_mm_min,
                                          std::chars_format::fixed);
  const std::string_view text(digits.data(), shortest_end.ptr - digits.data());
  const std::optional<double> read = parse_number(text);
  if (read && static_cast<float>(*read) == feed_mm_min) return std::string(text);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 static_cast<double>(feed_mm_min), std::chars_format::fixed);
  return std::string(digits.data(), end.ptr);
}

}  // namespace limitgauge::model
