#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Tip positions to be cut in one go at the feed.
struct CutPass {
  std::vector<model::Vec3> tips;
  bool closed = false;      ///< may start anywhere; the first point is not repeated
  bool reversible = false;  ///< may be cut from its end
  /// Material stands where the pass begins, up to this height: the cutter ramps down from there.
  std::optional<double> stands_to_mm;
};

/// May be cut from its end where the pattern is to and fro.
inline CutPass row_pass(std::vector<model::Vec3> tips, const StageRequest& request) {
  CutPass pass;
  pass.tips = std::move(tips);
  pass.reversible = request.cut.pattern == RowPattern::zigzag;
  return pass;
}

/// Of tips that go climb: turned round for conventional, from either end where both will do.
inline CutPass contour_pass(std::vector<model::Vec3> tips, bool closed,
                            const StageRequest& request) {
  if (request.cut.direction == CutDirection::conventional) std::reverse(tips.begin(), tips.end());
  CutPass pass;
  pass.tips = std::move(tips);
  pass.closed = closed;
  pass.reversible = request.cut.direction == CutDirection::either;
  return pass;
}

}  // namespace limitgauge::engine::strategy
