#include "reports/json/inputs_part.h"

#include "reports/text/text.h"

namespace limitgauge::reports::json {

Json inputs_part(const std::vector<InputFile>& inputs) {
  Json out = Json::array();
  for (const InputFile& input : inputs)
    out.push_back({{"role", clean_text(input.role)},
                   {"file", clean_text(input.file)},
                   {"bytes", input.bytes},
                   {"sha256", input.sha256}});
  return out;
}

}  // namespace limitgauge::reports::json
