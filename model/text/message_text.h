#pragma once

#include <span>
#include <string>
#include <string_view>

namespace limitgauge::model {

/// `text`, which somebody else wrote, between single quotes for a message: cut short where it is
/// long and with `?` for all but printable ASCII.
std::string in_quotes(std::string_view text);
/// The same of one character; the byte's value where it cannot be printed.
std::string in_quotes(char c);

/// Of `known`, the first of those that the fewest slips turn `word` into; empty where `known` is. A
/// slip adds, drops or changes a letter or swaps two neighbours; case does not count, and only the
/// first 64 letters do.
std::string nearest_word(std::string_view word, std::span<const std::string_view> known);
/// The nearest word where it is near enough to be what was meant; empty where more than a third of
/// the letters (or the only one) would change, or where `word` has more than 64.
std::string meant_word(std::string_view word, std::span<const std::string_view> known);

}  // namespace limitgauge::model
