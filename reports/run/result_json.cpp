#include "reports/run/report.h"

#include "reports/json/result_parts.h"
#include "reports/text/embedded.h"
#include "reports/text/text.h"

namespace limitgauge::reports {

void write_result_json(const RunResult& result, std::ostream& out) {
  json::Json root = {{"schema", "limitgauge.result/2"},
                     {"job", clean_text(result.job)},
                     {"version", clean_text(result.version)},
                     {"created", clean_text(result.created)},
                     {"threads", result.threads},
                     {"verdict", verifier::name(result.verdict)}};
  if (!result.label.empty()) root["label"] = clean_text(result.label);
  root["inputs"] = json::inputs_part(result.inputs);
  root["stock"] = json::stock_part(result.raw_stock);
  if (result.surface) root["surface"] = json::surface_part(*result.surface);
  root["programs"] = json::programs_part(result);
  if (!result.setups.empty()) root["setups"] = json::setups_part(result.setups);
  if (result.tolerances) root["tolerances"] = json::tolerances_part(*result.tolerances);
  root["stages"] = json::Json::array();
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    root["stages"].push_back(json::stage_part(result, i));
  root["assumptions"] = json::texts(result.assumptions);
  root["process_limits"] = json::process_limits_part(result.process_limits);
  if (!result.overrides.empty()) root["overrides"] = json::texts(result.overrides);
  out << root.dump(1) << '\n';
}

const std::string& result_schema() {
  static const std::string text{embedded::result_schema()};
  return text;
}

std::string recorded_stage(const RunResult& result, std::size_t index) {
  return json::stage_part(result, index).dump();
}

bool is_recorded_stage(const std::string& text) {
  const json::Json entry = json::Json::parse(text, nullptr, false);
  if (!entry.is_object() || !entry.contains("simulation")) return false;
  const auto lines = entry.find("program_lines");
  if (lines == entry.end() || !lines->is_array()) return false;
  for (const json::Json& line : *lines)
    if (!line.is_object() || !line.contains("line") || !line["line"].is_number_unsigned())
      return false;
  return true;
}

}  // namespace limitgauge::reports
