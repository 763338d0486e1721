#include "model/part/toolpath.h"

#include <cmath>
#include <stdexcept>

namespace limitgauge::model {
namespace {

void require_unit(const Vec3& axis) {
  constexpr double kUnit = 1e-9;
  if (!(std::abs(length(axis) - 1) <= kUnit))
    throw std::invalid_argument("an axis of a tool is a unit vector");
}

}  // namespace

void require_axes(const Toolpath& path, const ToolAxes& axes) {
  if (axes.to.size() != path.moves.size())
    throw std::invalid_argument("a path that turns its tool has an axis for each move");
  require_unit(axes.start);
  for (std::size_t i = 0; i < axes.to.size(); ++i) {
    require_unit(axes.to[i]);
    if (!(dot(axis_from(axes, i), axes.to[i]) >= 0))
      throw std::invalid_argument("a move turns its tool by more than 90 degrees");
  }
}

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

ToolAxes turned(const ToolAxes& axes, const Pose& pose) {
  ToolAxes out = axes;
  out.start = pose.direction(axes.start);
  for (Vec3& axis : out.to) axis = pose.direction(axis);
  return out;
}

Arc turned(const Arc& arc, const Pose& pose) {
  Arc out = arc;
  out.centre = pose.point(arc.centre);
  out.axis1 = pose.direction(arc.axis1), out.axis2 = pose.direction(arc.axis2);
  out.rise_mm = pose.direction(arc.rise_mm);
  return out;
}

Toolpath turned(const Toolpath& path, const Pose& pose) {
  Toolpath out = path;
  out.start = pose.point(path.start);
  for (Move& move : out.moves) move.to = pose.point(move.to);
  for (ArcMoves& arc : out.arcs) arc.arc = turned(arc.arc, pose);
  return out;
}

}  // namespace limitgauge::model
