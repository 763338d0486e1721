#pragma once

#include <toml++/toml.h>

#include <string>

#include "study/store/table.h"

namespace limitgauge::app {

/// A value of a TOML file as a setting of a study: numbers with the fewest digits that read back as
/// they are, so that 0.20 and 0.2 are the same setting. Throws InputError at the value's place for
/// what no job key takes (dates) and for numbers that are not finite; `what` names it there.
study::Setting setting_of(const toml::node& value, const std::string& what);

}  // namespace limitgauge::app
