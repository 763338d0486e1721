#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/strategy/linking.h"

namespace limitgauge::engine::strategy {

inline CutPass row_pass(std::vector<Vec3> tips, const StageRequest& request) {
  CutPass pass;
  pass.tips = std::move(tips);
  pass.reversible = request.cut.pattern == RowPattern::zigzag;
  return pass;
}

inline void set_intervals(StagePath& stage, std::vector<int> intervals) {
  const auto [least, most] = std::minmax_element(intervals.begin(), intervals.end());
  if (least != intervals.end()) {
    stage.sampling_interval_min = *least;
    stage.sampling_interval_max = *most;
  }
  stage.sampling_intervals = std::move(intervals);
}

}  // namespace limitgauge::engine::strategy
