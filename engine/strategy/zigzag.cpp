#include "engine/strategy/zigzag.h"

#include <algorithm>

#include "engine/strategy/drive_rows.h"
#include "engine/strategy/row_links.h"

namespace limitgauge::engine::strategy {

StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control) {
  const DriveRows rows = make_rows(model, request, control);
  StagePath stage;
  stage.path = link_rows(rows, request);
  stage.planes = static_cast<int>(rows.rows.size());
  stage.sampling_intervals = rows.sampling_intervals;
  const auto [low, high] =
      std::minmax_element(rows.sampling_intervals.begin(), rows.sampling_intervals.end());
  stage.sampling_interval_min = *low;
  stage.sampling_interval_max = *high;
  return stage;
}

}  // namespace limitgauge::engine::strategy
