#pragma once

#include <optional>
#include <string>

#include "app/run/stage_prefix.h"

namespace limitgauge::app {

/// The stages of `prefix` as bytes for this program on machines of this kind: paths to the last
/// bit, programs, and what was measured. Model and stock are left out.
std::string to_text(const StagePrefix& prefix);
/// Nothing for bytes that are not what to_text() makes.
std::optional<StagePrefix> read_stage_prefix(std::string_view text);

}  // namespace limitgauge::app
