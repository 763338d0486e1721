#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verifier/reach/reach_map.h"

namespace limitgauge::verifier {

/// The entries of a map, and back; nothing for bytes that are none.
std::string entries_to_bytes(const std::vector<ReachMap::Entry>& entries);
std::optional<std::vector<ReachMap::Entry>> entries_of_bytes(std::string_view bytes);

}  // namespace limitgauge::verifier
