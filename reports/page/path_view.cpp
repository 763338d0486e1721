#include "reports/page/path_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/polyline.h"
#include "model/geometry/segment.h"

namespace limitgauge::reports::page {
namespace {

using model::MoveKind;
using model::ToolAxes;
using model::Toolpath;
using model::Vec3;

/// Indices of the moves that segments end with, ascending.
using Ends = std::vector<std::uint32_t>;

double angle_rad(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// From `axis` to the nearest place of the arc of a great circle from `a` to `b`; of opposite ones,
/// between which there are many, to the nearer end.
double angle_to_arc_rad(const Vec3& axis, const Vec3& a, const Vec3& b) {
  constexpr double kNoTurn = 1e-9;
  const double to_end = std::min(angle_rad(axis, a), angle_rad(axis, b));
  const Vec3 across = cross(a, b);
  const double sine = length(across);
  if (sine < kNoTurn) return to_end;
  const Vec3 normal = across / sine;
  const bool beside = dot(cross(a, axis), normal) >= 0 && dot(cross(axis, b), normal) >= 0;
  return beside ? std::asin(std::min(1.0, std::abs(dot(axis, normal)))) : to_end;
}

/// What may be joined.
struct Rule {
  double within_mm = 0, within_rad = 0;
  bool feeds = false, kinds = false;  ///< different ones may be joined

  bool joins(const model::Move& a, const model::Move& b) const {
    if (a.kind != b.kind) return kinds;
    return feeds || a.kind == MoveKind::rapid || a.feed_mm_min == b.feed_mm_min;
  }
};

/// Joins moves by one rule.
class Joiner {
 public:
  Joiner(const Toolpath& path, const ToolAxes* axes, const Rule& rule)
      : path_(path), axes_(axes), rule_(rule) {}

  Ends joined() const {
    const auto kept = model::reduce_chords(
        path_.moves.size() + 1,
        [&](std::size_t from, std::size_t to) { return holds(from, to - from); });
    Ends out;
    for (std::size_t k = 1; k < kept.size(); ++k)
      out.push_back(static_cast<std::uint32_t>(kept[k] - 1));
    return out;
  }

 private:
  /// Whether `count` moves from `first` on may be one segment.
  bool holds(std::size_t first, std::size_t count) const {
    const std::size_t last = first + count - 1;
    const Vec3& from = model::move_from(path_, first);
    const Vec3& to = path_.moves[last].to;
    const double squared = rule_.within_mm * rule_.within_mm;
    for (std::size_t i = first; i < last; ++i)
      if (!rule_.joins(path_.moves[i], path_.moves[i + 1]) ||
          squared_distance_to_segment(path_.moves[i].to, from, to) > squared)
        return false;
    return !axes_ || turns(first, last);
  }

  bool turns(std::size_t first, std::size_t last) const {
    const Vec3& from = axis_from(*axes_, first);
    for (std::size_t i = first; i < last; ++i)
      if (angle_to_arc_rad(axes_->to[i], from, axes_->to[last]) > rule_.within_rad) return false;
    return true;
  }

  const Toolpath& path_;
  const ToolAxes* axes_;
  const Rule& rule_;
};

double extent_mm(const Toolpath& path) {
  model::Box3 box;
  box.add(path.start);
  for (const model::Move& move : path.moves) box.add(move.to);
  return length(box.size());
}

/// Distances grow by a fourth root of 2 a level, from a 65536th of the path's extent to all of it,
/// where everything is one segment; angles likewise, from a 65536th of half a turn.
constexpr int kLevels = 65;

Rule rule_at(int level, double extent) {
  // Of a path that stays where it is, too, everything must come to be joined.
  const double within = std::max(extent, 1e-3) * std::exp2(0.25 * level - 16);
  const double within_rad = std::numbers::pi * std::exp2(0.25 * level - 16);
  return {within, within_rad, within > extent / 500, within > extent / 50};
}

Ends joined_at(int level, const Toolpath& path, const ToolAxes* axes, double extent) {
  const Rule rule = rule_at(level, extent);
  return Joiner(path, axes, rule).joined();
}

/// By the least level that is found to fit.
Ends fitting(const Toolpath& path, const ToolAxes* axes, std::size_t most) {
  const double extent = extent_mm(path);
  int too_low = -1, fits = kLevels;
  Ends ends = joined_at(fits, path, axes, extent);
  while (fits - too_low > 1) {
    const int level = (too_low + fits) / 2;
    Ends joined = joined_at(level, path, axes, extent);
    if (joined.size() > most) {
      too_low = level;
    } else {
      fits = level, ends = std::move(joined);
    }
  }
  return ends;
}

/// Every move a segment.
Ends all_moves(const Toolpath& path) {
  Ends ends(path.moves.size());
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::uint32_t>(i);
  return ends;
}

/// Largest distance of a tip from the segment that its move belongs to.
double farthest_mm(const Toolpath& path, const Ends& ends) {
  double most = 0;
  std::size_t first = 0;
  for (const std::uint32_t last : ends) {
    const Vec3& from = model::move_from(path, first);
    for (std::size_t i = first; i < last; ++i)
      most =
          std::max(most, squared_distance_to_segment(path.moves[i].to, from, path.moves[last].to));
    first = last + std::size_t(1);
  }
  return std::sqrt(most);
}

/// Largest angle of an axis from the arc of the segment that its move belongs to.
double farthest_deg(const ToolAxes& axes, const Ends& ends) {
  double most = 0;
  std::size_t first = 0;
  for (const std::uint32_t last : ends) {
    for (std::size_t i = first; i < last; ++i)
      most = std::max(most, angle_to_arc_rad(axes.to[i], axis_from(axes, first), axes.to[last]));
    first = last + std::size_t(1);
  }
  return most * 180 / std::numbers::pi;
}

/// What the moves of a segment add up to.
struct Sums {
  double time_s = 0, feed_mm = 0, feed_s = 0, volume_mm3 = 0;
  bool feeds = false, several = false;
  float feed_mm_min = 0;

  void add(const model::Move& move, double length_mm, double rapid_mm_min) {
    const bool rapid = move.kind == MoveKind::rapid;
    const double rate = rapid ? rapid_mm_min : static_cast<double>(move.feed_mm_min);
    const double seconds = rate > 0 ? 60 * length_mm / rate : 0;
    time_s += seconds;
    if (rapid) return;
    several = several || (feeds && move.feed_mm_min != feed_mm_min);
    if (!feeds) feed_mm_min = move.feed_mm_min;
    feeds = true, feed_mm += seconds > 0 ? length_mm : 0, feed_s += seconds;
  }
  float feed() const {
    if (!several) return feed_mm_min;
    return feed_s > 0 ? static_cast<float>(60 * feed_mm / feed_s) : 0;
  }
};

PathView::Segment segment_of(const Toolpath& path, std::uint32_t last, const Sums& sums,
                             double scale) {
  const model::Move& move = path.moves[last];
  PathView::Segment s;
  s.to = move.to;
  s.kind = sums.feeds ? MoveKind::feed : MoveKind::rapid;
  s.feed_mm_min = sums.feed();
  const double minutes = sums.time_s * scale / 60;
  if (minutes > 0) s.rate_mm3_min = static_cast<float>(sums.volume_mm3 / minutes);
  s.line = move.line, s.move = last;
  return s;
}

}  // namespace

PathView path_view(const Toolpath& path, std::span<const simulator::MoveRemoval> removal,
                   const PathViewOptions& options) {
  PathView view;
  view.start = path.start, view.moves = path.moves.size();
  view.has_rates = !removal.empty() && removal.size() == path.moves.size();
  const std::size_t most = std::max<std::size_t>(options.most_segments, 1);
  const Ends ends = view.moves > most ? fitting(path, options.axes, most) : all_moves(path);
  view.within_mm = farthest_mm(path, ends);
  if (options.axes)
    view.start_axis = options.axes->start, view.axis_within_deg = farthest_deg(*options.axes, ends);
  const double programmed_s = model::lengths(path, options.rapid_mm_min).time_s;
  const bool scaled = options.machining_time_s > 0 && programmed_s > 0;
  const double scale = scaled ? options.machining_time_s / programmed_s : 1;
  double time_s = 0;
  std::size_t i = 0;
  for (const std::uint32_t last : ends) {
    Sums sums;
    for (; i <= last; ++i) {
      sums.add(path.moves[i], distance(model::move_from(path, i), path.moves[i].to),
               options.rapid_mm_min);
      if (view.has_rates) sums.volume_mm3 += removal[i].volume_mm3;
    }
    if (options.axes) view.axes.push_back(options.axes->to[last]);
    view.segments.push_back(segment_of(path, last, sums, scale));
    view.segments.back().end_s = time_s += sums.time_s * scale;
  }
  return view;
}

}  // namespace limitgauge::reports::page
