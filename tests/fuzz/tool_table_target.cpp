#include <cmath>

#include "model/machine/machine_setup.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

namespace {

void require_entry(const model::ToolEntry& tool) {
  fuzz::require(tool.number >= 0, "tool numbers are not negative");
  fuzz::require(std::isfinite(tool.length_mm.value_or(0)), "lengths are finite");
  fuzz::require(std::isfinite(tool.diameter_mm.value_or(0)), "diameters are finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  for (const bool inch : {false, true})
    fuzz::answer([&] {
      for (const auto& tool : model::parse_tool_table(text, "tool.tbl", inch)) require_entry(tool);
    });
  return 0;
}
