#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "verifier/gate/deviation.h"

namespace limitgauge::app {

/// Sets the limit of what cannot be reached from "0.05" (a share of the surface, 0 to 1) or
/// "12.5 mm2" (an area, zero or more). False, and nothing changed, for any other text.
bool set_unreachable(std::string_view text, verifier::GateLimits& limits);
/// The limit as `set_unreachable` takes it.
std::string unreachable_text(const verifier::GateLimits& limits);

/// What such a text is expected to be, for errors.
inline constexpr const char* kUnreachableExpected =
    "a share from 0 to 1, or an area as \"12.5 mm2\"";

/// Whether a coverage that is gated has a limit to be within.
inline bool coverage_has_limit(const verifier::GateLimits& limits) {
  return !limits.has_coverage || limits.has_gouge || limits.has_uncut;
}
inline constexpr const char* kCoverageWithoutLimit =
    "without a limit of gouge or uncut all of the surface is within";
inline constexpr const char* kCoverageExpected = "one of the two to be stated beside it";

}  // namespace limitgauge::app
