#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/run_result.h"

/// Values as the reports' JSON has them; `key` names a figure in the error that is thrown when it
/// is not finite.
namespace limitgauge::reports::json {

/// Keys in the order in which they are put in.
using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity: a figure that is one is a bug of whoever measured it. Throws
/// std::domain_error that names it.
double finite(std::string_view key, double value);
Json point(const char* key, const model::Vec3& p);
Json numbers(const char* key, const std::vector<double>& values);
Json interval(const char* key, const verifier::Interval& i);
Json texts(const std::vector<std::string>& lines);
/// The name of a stage by its index.
std::string stage_name(const RunResult& result, std::size_t stage);

}  // namespace limitgauge::reports::json
