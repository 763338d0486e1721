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

/// Digits with at most one decimal point among them.
struct DigitRun {
  /// A whole number of so many digits, and every power of ten up to it, is a double.
  static constexpr std::ptrdiff_t kExactDigits = 15;

  std::uint64_t whole = 0;               ///< all digits as one number; modulo 2^64
  std::ptrdiff_t count = 0;              ///< of digits
  std::ptrdiff_t decimals = 0;           ///< of them behind the point
  const char* end = nullptr;             ///< the byte behind them
  bool has_point = false, more = false;  ///< another point follows

  bool is_exact() const { return count <= kExactDigits; }
  /// Of an exact one: a whole number over a power of ten, so that one division rounds rightly
  /// (Clinger 1990).
  double value() const {
    return static_cast<double>(whole) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  }
};

inline DigitRun read_digits(const char* begin, const char* limit) {
  DigitRun run;
  const char* at = begin;
  const auto go_on = [&] {
    for (; at < limit && is_digit(*at); ++at)
      run.whole = run.whole * 10 + static_cast<std::uint64_t>(*at - '0');
  };
  go_on();
  run.count = at - begin;
  run.has_point = at < limit && *at == '.';
  if (run.has_point) {
    const char* const behind = ++at;
    go_on();
    run.decimals = at - behind;
    run.count += run.decimals;
    run.more = at < limit && *at == '.';
  }
  run.end = at;
  return run;
}

/// A number without a sign and the byte behind it.
struct PlainNumber {
  double value = 0;
  const char* end = nullptr;
};

/// Reads digits with at most one decimal point among them at `begin`, exactly rounded. Nothing
/// where there is no digit or what follows is another point.
inline std::optional<PlainNumber> read_plain_number(const char* begin, const char* limit) {
  const DigitRun run = read_digits(begin, limit);
  if (run.count == 0 || run.more) return std::nullopt;
  if (run.is_exact()) return PlainNumber{run.value(), run.end};
  PlainNumber number{0, run.end};
  const auto [stop, error] =
      std::from_chars(begin, run.end, number.value, std::chars_format::fixed);
  if (error != std::errc() || stop != run.end) return std::nullopt;
  return number;
}

}  // namespace limitgauge::model::gcode
