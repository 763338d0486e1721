#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "model/text/characters.h"

namespace limitgauge::model::gcode {

/// Powers of ten that a double holds exactly.
inline constexpr std::array<double, 23> kPowersOfTen = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A number without a sign and the byte behind it.
struct PlainNumber {
  double value = 0;
  const char* end = nullptr;
};

/// Reads digits with at most one decimal point among them at `begin`, exactly rounded. Nothing
/// where there is no digit or what follows is another point. Numbers of up to 15 digits are a whole
/// number over a power of ten, both exact, so that one division rounds rightly (Clinger 1990).
inline std::optional<PlainNumber> read_plain_number(const char* begin, const char* limit) {
  constexpr std::ptrdiff_t kExactDigits = 15;
  const char* at = begin;
  std::uint64_t digits = 0;
  for (; at < limit && is_digit(*at); ++at)
    digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
  std::ptrdiff_t count = at - begin, decimals = 0;
  if (at < limit && *at == '.') {
    const char* const point = at++;
    for (; at < limit && is_digit(*at); ++at)
      digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
    decimals = at - point - 1;
    count += decimals;
    if (at < limit && *at == '.') return std::nullopt;
  }
  if (count == 0) return std::nullopt;
  if (count <= kExactDigits)
    return PlainNumber{
        static_cast<double>(digits) / kPowersOfTen[static_cast<std::size_t>(decimals)], at};
  PlainNumber number{0, at};
  const auto [stop, error] = std::from_chars(begin, at, number.value, std::chars_format::fixed);
  if (error != std::errc() || stop != at) return std::nullopt;
  return number;
}

}  // namespace limitgauge::model::gcode
