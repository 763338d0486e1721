#include "simulator/sweep/move_runs.h"

#include <algorithm>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

bool goes_on(const Vec3& direction, const Vec3& way) {
  return dot(direction, way) > 0 &&
         length(cross(direction, way)) <= kSameDirection * length(direction) * length(way);
}

}  // namespace

std::size_t MoveRuns::begin(std::size_t move) const {
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), move);
  return after == begins_.begin() ? move : *(after - 1);
}

std::size_t MoveRuns::end(std::size_t move) const {
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), move);
  return after == begins_.end() ? moves_ : *after;
}

MoveRuns straight_runs(const model::Toolpath& path) {
  // Of the run: its first direction, so that many small turns are no line.
  Vec3 direction;
  return MoveRuns(path.moves.size(), [&](std::size_t i) {
    const Vec3 way = path.moves[i].to - move_from(path, i);
    const bool still = length_squared(way) == 0, open = length_squared(direction) == 0;
    const bool joins = i > 0 && path.moves[i].kind == path.moves[i - 1].kind &&
                       (still || open || goes_on(direction, way));
    if (!joins || open) direction = way;
    return !joins;
  });
}

bool lacks_feed(const model::Move& move) {
  return move.kind == model::MoveKind::feed && !(move.feed_mm_min > 0);
}

IdleSeries::IdleSeries(const model::Toolpath& path)
    : rapids(
          series_of(path.moves.size(),
                    [&](std::size_t i) { return path.moves[i].kind == model::MoveKind::rapid; })),
      spindle_stopped(series_of(path.moves.size(),
                                [&](std::size_t i) { return path.moves[i].spindle_stopped; })),
      without_feed(
          series_of(path.moves.size(), [&](std::size_t i) { return lacks_feed(path.moves[i]); })) {}

}  // namespace limitgauge::simulator
