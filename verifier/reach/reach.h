#pragma once

#include <cstdint>

namespace limitgauge::verifier {

/// What was proven of all points of a cell, or of one.
enum class Reach : std::uint8_t { undecided, reachable, unreachable };

}  // namespace limitgauge::verifier
