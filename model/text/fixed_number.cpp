#include "model/text/fixed_number.h"

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "model/text/number_text.h"

namespace limitgauge::model {

FixedNumber fixed(double value, int decimals, bool point) {
  FixedNumber number;
  const auto [end, error] =
      std::to_chars(number.digits.data(), number.digits.data() + number.digits.size() - 1, value,
                    std::chars_format::fixed, decimals);
  number.length = end - number.digits.data();
  if (decimals > 0) {
    number.length = number.text().find_last_not_of('0') + 1;
    if (number.text().back() == '.') --number.length;
  }
  if (number.text() == "-0") number.digits[0] = '0', number.length = 1;
  std::from_chars(number.digits.data(), number.digits.data() + number.length, number.value);
  if (point && number.text().find('.') == std::string_view::npos)
    number.digits[number.length++] = '.';
  return number;
}

Vec3 rounded(const Vec3& point, int decimals) {
  return {fixed(point.x, decimals).value, fixed(point.y, decimals).value,
          fixed(point.z, decimals).value};
}

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
