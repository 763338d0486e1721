#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>

namespace limitgauge::app {

/// Replaces or adds keys of `job` by `overrides` of the form `dotted.key=value`. The value is TOML;
/// a word that is none is taken as text. Throws InputError that names the override.
void apply_overrides(toml::table& job, std::span<const std::string> overrides);

}  // namespace limitgauge::app
