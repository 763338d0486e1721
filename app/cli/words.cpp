#include "app/cli/words.h"

#include <array>
#include <charconv>

namespace limitgauge::app {

std::string words(double value) {
  std::array<char, 40> text{};
  const auto [end, status] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

}  // namespace limitgauge::app
