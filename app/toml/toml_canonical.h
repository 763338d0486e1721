#pragma once

#include <toml++/toml.h>

#include <string>

namespace limitgauge::app {

/// A text that two values share if and only if they have the same types and values: keys in their
/// order, numbers to the last bit, no comments.
std::string canonical(const toml::node& node);

}  // namespace limitgauge::app
