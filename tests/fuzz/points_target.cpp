#include "model/base/coordinate_limit.h"
#include "model/part/measured_points.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::answer([&] {
    const model::MeasuredPoints read =
        model::parse_measured_points(fuzz::text_of(data, size), "points.csv");
    fuzz::require(!read.points.empty(), "a table without points is refused");
    for (const model::MeasuredPoint& point : read.points) {
      fuzz::require(model::is_near(point.at_mm), "points are near zero");
      fuzz::require((point.u_mm > 0) == read.has_uncertainty, "uncertainties are above zero");
      fuzz::require(point.line > 1, "the header comes first");
    }
  });
  return 0;
}
