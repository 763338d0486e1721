#include "model/text/rounded.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <compare>

namespace limitgauge::model {
namespace {

/// In units of the last place shown: a number that is nearer to a whole one has no further places
/// but for its binary form, which is off by less than this up to some 1e9 of these units.
constexpr double kWholePlace = 1e-6;
/// What a double of everyday size can still tell apart.
constexpr int kMostDecimals = 15;

double rounded_number(double value, int decimals, Rounding rounding) {
  const double scale = std::pow(10.0, decimals), places = value * scale;
  const double nearest = std::round(places);
  if (rounding == Rounding::nearest || std::abs(places - nearest) < kWholePlace)
    return nearest / scale;
  return (rounding == Rounding::down ? std::floor(places) : std::ceil(places)) / scale;
}

double read_back(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::string with_decimals(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  std::string text{buffer.data(), end};
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string rounded_text(double value, int decimals, Rounding rounding,
                         const std::optional<double>& limit) {
  std::string text = with_decimals(rounded_number(value, decimals, rounding), decimals);
  if (!limit) return text;
  const std::partial_ordering side = value <=> *limit;
  while ((read_back(text) <=> *limit) != side && ++decimals <= kMostDecimals)
    text = with_decimals(rounded_number(value, decimals, rounding), decimals);
  return text;
}

int significant_decimals(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return std::clamp(digits - 1 - magnitude, 0, 9);
}

double without_dust(double value) {
  return std::round(value * 1e9) / 1e9;
}

std::string without_trailing_zeros(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return number;
}

std::string factor_text(double factor, Rounding rounding) {
  constexpr int kDigits = 4;
  return without_trailing_zeros(
      rounded_text(factor, significant_decimals(factor, kDigits), rounding));
}

}  // namespace limitgauge::model
