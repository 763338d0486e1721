#include "reports/run/recorded_stage.h"

#include "reports/json/stage_part.h"

namespace limitgauge::reports {

std::string recorded_stage(const RunResult& result, std::size_t index) {
  return json::stage_part(result, index).dump();
}

bool is_recorded_stage(const std::string& text) {
  const json::Json entry = json::Json::parse(text, nullptr, false);
  if (!entry.is_object() || !entry.contains("deviation")) return false;
  const auto lines = entry.find("program_lines");
  if (lines == entry.end() || !lines->is_array()) return false;
  for (const json::Json& line : *lines)
    if (!line.is_object() || !line.contains("line") || !line["line"].is_number_unsigned())
      return false;
  return true;
}

}  // namespace limitgauge::reports
