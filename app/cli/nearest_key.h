#pragma once

#include <span>
#include <string>
#include <string_view>

namespace limitgauge::app {

/// The entry of `known` with the smallest edit distance to `word` (insertions, deletions,
/// substitutions, swaps of neighbours); the first of several. Empty where `known` is.
std::string nearest_key(std::string_view word, std::span<const std::string_view> known);

}  // namespace limitgauge::app
