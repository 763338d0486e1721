#include "reports/page/path_view.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::reports::page {
namespace {

using model::MoveKind;
using model::Toolpath;
using model::Vec3;

/// Indices of the moves that segments end with, ascending.
using Ends = std::vector<std::uint32_t>;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = length_squared(along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return distance(p, lerp(a, b, t));
}

/// What may be joined.
struct Rule {
  double within_mm = 0;
  bool feeds = false, kinds = false;  ///< different ones may be joined

  bool joins(const model::Move& a, const model::Move& b) const {
    if (a.kind != b.kind) return kinds;
    return feeds || a.kind == MoveKind::rapid || a.feed_mm_min == b.feed_mm_min;
  }
};

/// Joins neighbours of `ends` by one rule.
class Joiner {
 public:
  Joiner(const Toolpath& path, const Ends& ends, const Rule& rule)
      : path_(path), ends_(ends), rule_(rule) {}

  Ends joined() const {
    Ends out;
    for (std::size_t i = 0; i < ends_.size();) {
      i += longest(i);
      out.push_back(ends_[i - 1]);
    }
    return out;
  }

 private:
  /// How many from `first` on make one segment. By doubling, then halving: what is found holds,
  /// though a longer one might, too.
  std::size_t longest(std::size_t first) const {
    const std::size_t left = ends_.size() - first;
    std::size_t good = 1, step = 1;
    while (good + step <= left && holds(first, good + step)) good += step, step *= 2;
    for (; step > 0; step /= 2)
      if (good + step <= left && holds(first, good + step)) good += step;
    return good;
  }

  bool holds(std::size_t first, std::size_t count) const {
    const Vec3& from = first == 0 ? path_.start : tip(first - 1);
    const Vec3& to = tip(first + count - 1);
    for (std::size_t i = first; i + 1 < first + count; ++i)
      if (!rule_.joins(path_.moves[ends_[i]], path_.moves[ends_[i + 1]]) ||
          distance_to_segment(tip(i), from, to) > rule_.within_mm)
        return false;
    return true;
  }

  const Vec3& tip(std::size_t i) const { return path_.moves[ends_[i]].to; }

  const Toolpath& path_;
  const Ends& ends_;
  const Rule& rule_;
};

double extent_mm(const Toolpath& path) {
  model::Box3 box;
  box.add(path.start);
  for (const model::Move& move : path.moves) box.add(move.to);
  return length(box.size());
}

/// Every round joins what the one before left, so that all rounds together cost little more than
/// the first ones.
Ends fitting(const Toolpath& path, std::size_t most) {
  Ends ends(path.moves.size());
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::uint32_t>(i);
  const double extent = extent_mm(path);
  // Of a path that stays where it is, too, the rules must come to relax.
  for (double within = std::max(extent / 65536, 1e-6); ends.size() > most; within *= 2)
    ends = Joiner(path, ends, {within, within > extent / 500, within > extent / 50}).joined();
  return ends;
}

/// Largest distance of a tip from the segment that its move belongs to.
double farthest_mm(const Toolpath& path, const Ends& ends) {
  double most = 0;
  std::size_t first = 0;
  for (const std::uint32_t last : ends) {
    const Vec3& from = model::move_from(path, first);
    for (std::size_t i = first; i < last; ++i)
      most = std::max(most, distance_to_segment(path.moves[i].to, from, path.moves[last].to));
    first = last + std::size_t(1);
  }
  return most;
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
  const Ends ends = fitting(path, std::max<std::size_t>(options.most_segments, 1));
  view.within_mm = farthest_mm(path, ends);
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
    view.segments.push_back(segment_of(path, last, sums, scale));
    view.segments.back().end_s = time_s += sums.time_s * scale;
  }
  return view;
}

}  // namespace limitgauge::reports::page
