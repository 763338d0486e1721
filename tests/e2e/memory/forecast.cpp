#include "tests/e2e/memory/forecast.h"

#include "tests/support/catch.h"

namespace limitgauge::e2e {

void check_forecast(const Outcome& outcome) {
  constexpr double kMib = 1024.0 * 1024.0;
  constexpr double kFactor = 1.5;
  const std::string mark = "the run is forecast to take ";
  const std::size_t at = outcome.errors.find(mark);
  REQUIRE(at != std::string::npos);
  const double forecast = kMib * std::stod(outcome.errors.substr(at + mark.size()));
  INFO("forecast " << forecast / kMib << " MiB, taken " << outcome.peak_bytes / kMib << " MiB");
  CHECK(outcome.peak_bytes < kFactor * forecast);
  CHECK(outcome.peak_bytes > forecast / kFactor);
}

}  // namespace limitgauge::e2e
