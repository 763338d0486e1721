#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace limitgauge::model {

/// The number that the whole of `text` spells in C notation (an extra leading `+` is allowed), or
/// nothing. Infinities, NaN and what a double cannot hold are no numbers here.
std::optional<double> parse_number(std::string_view text);
/// The shortest decimals that read back as exactly `value`, in scientific notation where that is
/// shorter. Negative zero is written as 0.
std::string shortest(double value);
/// `value` with at most six significant digits, for messages: six tell what is wrong, seventeen
/// hide it.
std::string six_digits(double value);

}  // namespace limitgauge::model
