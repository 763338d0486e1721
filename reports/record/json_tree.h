#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace limitgauge::reports::record {

/// `text` as a tree. Throws model::InputError with the line and column of what is no JSON, of a
/// number that is too large for a double, and for nesting so deep that no result has it.
nlohmann::json parse_json(const std::string& text, const std::string& shown);

}  // namespace limitgauge::reports::record
