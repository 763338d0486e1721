#include "reports/json/values.h"

#include <cmath>
#include <stdexcept>

#include "reports/text/text.h"

namespace limitgauge::reports::json {

double finite(std::string_view key, double value) {
  if (!std::isfinite(value))
    throw std::domain_error("a report's " + std::string(key) + " is not a finite number");
  return value;
}

Json point(const char* key, const model::Vec3& p) {
  return Json::array({finite(key, p.x), finite(key, p.y), finite(key, p.z)});
}

Json texts(const std::vector<std::string>& lines) {
  Json out = Json::array();
  for (const std::string& line : lines) out.push_back(clean_text(line));
  return out;
}

Json numbers(const char* key, const std::vector<double>& values) {
  Json out = Json::array();
  for (const double v : values) out.push_back(finite(key, v));
  return out;
}

Json interval(const char* key, const verifier::Interval& i) {
  return {{"low", finite(key, i.low)}, {"high", finite(key, i.high)}};
}

std::string stage_name(const RunResult& result, std::size_t stage) {
  return stage < result.stages.size() ? clean_text(result.stages[stage].name) : "";
}

}  // namespace limitgauge::reports::json
