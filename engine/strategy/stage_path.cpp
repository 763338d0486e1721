#include "engine/strategy/stage_path.h"

#include <algorithm>
#include <utility>

namespace limitgauge::engine::strategy {

void set_intervals(StagePath& stage, std::vector<int> intervals) {
  const auto [least, most] = std::minmax_element(intervals.begin(), intervals.end());
  if (least != intervals.end()) {
    stage.sampling_interval_min = *least;
    stage.sampling_interval_max = *most;
  }
  stage.sampling_intervals = std::move(intervals);
}

}  // namespace limitgauge::engine::strategy
