#include "model/base/fixed_number.h"

#include <charconv>

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

}  // namespace limitgauge::model
