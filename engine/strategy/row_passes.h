#pragma once

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

}  // namespace limitgauge::engine::strategy
