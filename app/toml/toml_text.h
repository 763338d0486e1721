#pragma once

#include <string>

#include <toml++/toml.h>

#include "model/base/error.h"

namespace limitgauge::app {

/// Dots in a line of TOML, or in the key of an override.
inline constexpr int kMostDots = 100;

/// Reads TOML. Throws InputError with line and column for what is none, OtherBase for numbers that
/// are not decimal, and InputError for lines of more than
/// kMostDots dots: every part of a dotted key is a table in a table, toml++ takes them down by
/// recursion, and ten thousands of them exhaust the stack. It bounds all other nesting itself, at
/// 256 values.
toml::table parse_toml(const std::string& text, const std::string& name_in_errors);

/// A number in hexadecimal, octal or binary digits: in a job, a slip or a joke.
class OtherBase : public model::InputError {
  using InputError::InputError;
};

/// A value as TOML writes it, cut short where it is long: for errors.
std::string shown_value(const toml::node& value);

/// The table among `entries` whose `name` or `id` is `name`, as `--set stage.finish.step` means it;
/// null where there is none.
const toml::table* entry_named(const toml::array& entries, const std::string& name);
toml::table* entry_named(toml::array& entries, const std::string& name);

/// A text that two values share if and only if they have the same types and values: keys in their
/// order, numbers to the last bit, no comments.
std::string canonical(const toml::node& node);

}  // namespace limitgauge::app
