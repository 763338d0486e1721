#include "reports/json/inputs_part.h"
#include "reports/json/programs_part.h"
#include "reports/json/stage_part.h"
#include "reports/json/stock_part.h"
#include "reports/json/surface_part.h"
#include "reports/run/report.h"
#include "reports/text/text.h"

namespace limitgauge::reports {

void write_result_json(const RunResult& result, std::ostream& out) {
  json::Json root = {{"schema", "limitgauge.result/2"},
                     {"job", clean_text(result.job)},
                     {"version", clean_text(result.version)},
                     {"created", clean_text(result.created)},
                     {"threads", result.threads},
                     {"verdict", verifier::name(result.verdict)}};
  root["inputs"] = json::inputs_part(result.inputs);
  root["stock"] = json::stock_part(result.raw_stock);
  root["surface"] = json::surface_part(result.surface);
  root["programs"] = json::programs_part(result);
  root["stages"] = json::Json::array();
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    root["stages"].push_back(json::stage_part(result, i));
  root["assumptions"] = json::texts(result.assumptions);
  out << root.dump(1) << '\n';
}

}  // namespace limitgauge::reports
