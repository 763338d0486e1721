#include "reports/json_inputs.h"

#include "reports/text.h"

namespace limitgauge::reports {

nlohmann::ordered_json inputs_json(const std::vector<InputFile>& inputs) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const InputFile& input : inputs)
    out.push_back({{"role", clean_text(input.role)},
                   {"file", clean_text(input.file)},
                   {"bytes", input.bytes},
                   {"sha256", input.sha256}});
  return out;
}

}  // namespace limitgauge::reports
