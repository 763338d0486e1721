#include "model/part/toolpath.h"

namespace limitgauge::model {

ToolpathLengths lengths(const Toolpath& path, double rapid_mm_min) {
  ToolpathLengths sum;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    const double length_mm = distance(move_from(path, i), move.to);
    const bool rapid = move.kind == MoveKind::rapid;
    (rapid ? sum.rapid_mm : sum.cut_mm) += length_mm;
    const double rate_mm_min = rapid ? rapid_mm_min : static_cast<double>(move.feed_mm_min);
    if (rate_mm_min > 0) sum.time_s += 60 * length_mm / rate_mm_min;
  }
  return sum;
}

Toolpath turned(const Toolpath& path, const Pose& pose) {
  Toolpath out = path;
  out.start = pose.point(path.start);
  for (Move& move : out.moves) move.to = pose.point(move.to);
  return out;
}

}  // namespace limitgauge::model
