#include "app/case_runner.h"

#include "app/case_reading.h"
#include "app/stage_planner.h"
#include "simulator/raw_stock.h"

namespace limitgauge::app {

std::size_t forecast_bytes(const std::filesystem::path& job,
                           std::span<const std::string> overrides) {
  KnownFiles files;
  const ReadCase asked = read_case(job, overrides, files);
  return 0;
}

}  // namespace limitgauge::app
