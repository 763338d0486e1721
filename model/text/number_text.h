#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace limitgauge::model {

/// The number that the whole of `text` spells in C notation (an extra leading `+` is allowed), or
/// nothing. Infinities, NaN and what a double cannot hold are no numbers here.
std::optional<double> parse_number(std::string_view text);
/// The whole number that all of `text` spells in decimals; nothing for another text, or where the
/// type cannot hold it.
template <class Whole>
std::optional<Whole> parse_whole(std::string_view text) {
  Whole value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}
/// The shortest decimals that read back as exactly `value`, in scientific notation where that is
/// shorter. Negative zero is written as 0.
std::string shortest(double value);
/// `value` with at most six significant digits, for messages: six tell what is wrong, seventeen
/// hide it.
std::string six_digits(double value);

}  // namespace limitgauge::model
