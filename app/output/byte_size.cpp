#include "app/output/byte_size.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace limitgauge::app {

std::optional<std::uint64_t> bytes_of_text(const std::string& text) {
  constexpr std::string_view kLetters = "KMGT";
  constexpr double kMost = 9e18;
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !std::isfinite(value) || value < 0) return std::nullopt;
  std::string_view unit(at, static_cast<std::size_t>(end - at));
  if (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
  if (unit.empty() && at != end) return std::nullopt;
  if (!unit.empty() && unit != "B") {
    const std::size_t letter = kLetters.find(unit.front());
    const std::array<std::string_view, 3> tails = {"", "B", "iB"};
    if (letter == std::string_view::npos ||
        std::find(tails.begin(), tails.end(), unit.substr(1)) == tails.end())
      return std::nullopt;
    value *= std::pow(1024.0, static_cast<double>(letter + 1));
  }
  if (value > kMost) return std::nullopt;
  return static_cast<std::uint64_t>(value);
}

}  // namespace limitgauge::app
