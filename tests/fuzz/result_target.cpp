#include <cmath>
#include <sstream>

#include "reports/record/metrics.h"
#include "reports/record/record_reader.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;
using namespace limitgauge::reports;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::answer([&] {
    std::istringstream in(fuzz::text_of(data, size));
    const record::RunRecord run = record::read_result_json(in, "result.json");
    fuzz::require(run.threads > 0, "a run has threads");
    for (const record::StageRecord& stage : run.stages) {
      fuzz::require(stage.measures.has_value() == (stage.verdict != verifier::Verdict::not_run),
                    "a stage has measures unless it was not run");
      if (!stage.measures) continue;
      for (const record::Metric& metric : record::stage_metrics()) {
        const std::optional<verifier::Interval> figure = metric.of(*stage.measures);
        if (!figure) continue;
        fuzz::require(std::isfinite(figure->low) && std::isfinite(figure->high),
                      "figures are finite");
        fuzz::require(figure->low <= figure->high, "an interval rises");
      }
      if (!stage.measures->deviation) continue;
      for (const record::Place& place : stage.measures->deviation->gouges)
        fuzz::require(is_finite(place.at_mm) && place.depth_mm >= 0, "a place is one");
    }
  });
}
