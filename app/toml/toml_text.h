#pragma once

#include <toml++/toml.h>

#include <string>

namespace limitgauge::app {

/// Dots in a line of TOML, or in the key of an override.
inline constexpr int kMostDots = 100;

/// Reads TOML. Throws InputError with line and column for what is none, and for lines of more than
/// kMostDots dots: every part of a dotted key is a table in a table, toml++ takes them down by
/// recursion, and ten thousands of them exhaust the stack. It bounds all other nesting itself, at
/// 256 values.
toml::table parse_toml(const std::string& text, const std::string& name_in_errors);

}  // namespace limitgauge::app
