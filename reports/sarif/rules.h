#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace limitgauge::reports::sarif {

/// Keys in the order in which they are put in.
using Json = nlohmann::ordered_json;

/// What a verdict rests on besides findings.
inline constexpr const char* kCoverageRule = "coverage";
inline constexpr const char* kUnreachableRule = "unreachable";
inline constexpr const char* kUnavoidableRule = "unavoidable_uncut";
inline constexpr const char* kVerdictRule = "verdict";

/// "rules" of the tool: one for each kind of finding, with help, always all and in the same order.
Json rules();
/// Where the rule stands in `rules`.
std::size_t rule_index(const std::string& id);

}  // namespace limitgauge::reports::sarif
