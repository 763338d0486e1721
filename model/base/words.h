#pragma once

#include <cstddef>
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
/// Of `known`, the word that the fewest edits turn `word` into; empty where none is near enough to
/// be what was meant (more than a third of the letters would change). Case does not count.
std::string nearest_word(std::string_view word, const std::string_view* known, std::size_t count);

/// `text` between single quotes, cut short where it is long and with `?` for all but
/// printable ASCII, for error messages.
std::string in_quotes(std::string_view text);

}  // namespace limitgauge::model
