#include "engine/strategy/levels/level_passes.h"

#include <algorithm>
#include <limits>

#include "engine/strategy/raster/swept_raster.h"
#include "model/geometry/segment.h"

namespace limitgauge::engine::strategy {
namespace {

/// Loops nearer to each other than this many spacings are cut in the order of their groups.
constexpr double kNearLoops = 1.25;
/// How far outside the stock the cutter comes down beyond touching it, mm.
constexpr double kOutside_mm = 0.5;

/// Whether a point of `a` lies within `reach_mm` of `b`.
bool comes_near(const std::vector<FlatPoint>& a, const std::vector<FlatPoint>& b, double reach_mm) {
  for (const FlatPoint& p : a)
    for (std::size_t i = 0; i < b.size(); ++i)
      if (squared_distance_to_segment(p, b[i > 0 ? i - 1 : 0], b[i]) < reach_mm * reach_mm)
        return true;
  return false;
}

/// A loop and those that wait for it, by their numbers.
struct Waiting {
  Isoline line;
  std::size_t before = 0;  ///< loops still to be cut before it
  std::vector<std::size_t> behind;
  bool cut = false;
};

std::vector<Waiting> queued(std::vector<std::vector<Isoline>> groups, double reach_mm) {
  std::vector<Waiting> all;
  for (auto& group : groups) {
    const std::size_t earlier = all.size();
    for (Isoline& line : group) {
      for (std::size_t k = 0; k < earlier; ++k) {
        const auto& other = all[k].line.points;
        if (!comes_near(line.points, other, reach_mm) && !comes_near(other, line.points, reach_mm))
          continue;
        all[k].behind.push_back(all.size());
      }
      all.push_back({std::move(line), 0, {}, false});
    }
  }
  for (const Waiting& one : all)
    for (const std::size_t next : one.behind) ++all[next].before;
  return all;
}

class PassOrder {
 public:
  PassOrder(const LevelSpace& space, const StockOutline& outline, const LoopRule& loops,
            const PassRule& rule)
      : space_(space),
        outline_(outline),
        rule_(rule),
        at_{loops.stock.low.x, loops.stock.low.y},
        cleared_(space.raster(), without_stock(loops)) {}

  void add_all(std::vector<Waiting> loops) {
    if (rule_.direction == CutDirection::conventional)
      for (Waiting& one : loops) std::reverse(one.line.points.begin(), one.line.points.end());
    for (std::size_t n = 0; n < loops.size(); ++n) {
      const Start start = nearest(loops);
      Waiting& next = loops[start.line];
      add(turned(std::move(next.line), start.point));
      next.cut = true;
      for (const std::size_t k : next.behind) --loops[k].before;
    }
  }
  std::vector<LevelPass> take() { return std::move(passes_); }

 private:
  struct Start {
    std::size_t line = 0, point = 0;
  };

  static std::vector<std::uint8_t> without_stock(const LoopRule& loops) {
    std::vector<std::uint8_t> clear = loops.stock_pixels;
    for (std::uint8_t& flag : clear) flag = !flag;
    return clear;
  }

  /// Among the loops that wait for no other.
  Start nearest(const std::vector<Waiting>& loops) const {
    Start best;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t line, std::size_t point) {
      const double d = distance(loops[line].line.points[point], at_);
      if (d >= least) return;
      least = d;
      best = {line, point};
    };
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (loops[k].cut || loops[k].before > 0) continue;
      const std::size_t count = loops[k].line.points.size();
      look(k, 0);
      if (loops[k].line.closed)
        for (std::size_t i = 1; i + 1 < count; ++i) look(k, i);
      else if (rule_.direction == CutDirection::either)
        look(k, count - 1);
    }
    return best;
  }

  static LevelPass turned(Isoline line, std::size_t start) {
    auto& points = line.points;
    if (line.closed && points.size() > 1) {
      points.pop_back();
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start),
                  points.end());
      points.push_back(points.front());
    } else if (start != 0) {
      std::reverse(points.begin(), points.end());
    }
    return {Arrival::standing, std::move(points), line.closed, {}};
  }

  void add(LevelPass pass) {
    pass.arrival = arrival(pass.points.front());
    if (pass.arrival == Arrival::standing && !pass.closed) lead_in_from_outside(pass);
    if (pass.arrival == Arrival::standing) pass.helix = helix_centre(pass.points);
    cleared_.sweep(pass.points, rule_.cut_radius_mm);
    at_ = pass.points.back();
    passes_.push_back(std::move(pass));
  }

  Arrival arrival(const FlatPoint& to) const {
    const double sliver = space_.raster().pixel_mm;
    if (!passes_.empty() && distance(at_, to) <= rule_.longest_link_mm &&
        space_.clear_between(at_, to))
      return cleared_.is_swept(at_, to, rule_.cut_radius_mm - sliver) ? Arrival::link
                                                                      : Arrival::cut_link;
    return cleared_.is_swept(to, to, rule_.cut_radius_mm) ? Arrival::clear_air : Arrival::standing;
  }

  /// A loop that begins near the edge of the stock is cut from beside it.
  void lead_in_from_outside(LevelPass& pass) const {
    const FlatPoint first = pass.points.front(), way = outline_.outward(first);
    const double lead = rule_.widest_mm + kOutside_mm - outline_.distance_mm(first);
    if (lead <= 0 || lead > 2 * rule_.widest_mm) return;
    const FlatPoint outside{first.x + way.x * lead, first.y + way.y * lead};
    if (!space_.clear_between(outside, first)) return;
    pass.points.insert(pass.points.begin(), outside);
    pass.arrival = Arrival::clear_air;
  }

  /// On the side of the first stretch that leads away from the forbidden region.
  std::optional<FlatPoint> helix_centre(const std::vector<FlatPoint>& points) const {
    if (points.size() < 2) return std::nullopt;
    const FlatPoint a = points[0], b = points[1];
    const double length = distance(a, b);
    if (length <= 0) return std::nullopt;
    const double side = rule_.direction == CutDirection::conventional ? -1 : 1;
    const double reach = side * rule_.helix_radius_mm / length;
    const FlatPoint centre{a.x - (b.y - a.y) * reach, a.y + (b.x - a.x) * reach};
    if (space_.clear_at(centre) < rule_.helix_radius_mm) return std::nullopt;
    return centre;
  }

  const LevelSpace& space_;
  const StockOutline& outline_;
  const PassRule& rule_;
  FlatPoint at_;
  SweptRaster cleared_;
  std::vector<LevelPass> passes_;
};

}  // namespace

std::vector<LevelPass> order_loops(std::vector<std::vector<Isoline>> groups,
                                   const LevelSpace& space, const StockOutline& outline,
                                   const LoopRule& loops, const PassRule& rule) {
  PassOrder order(space, outline, loops, rule);
  order.add_all(queued(std::move(groups), kNearLoops * loops.spacing_mm));
  return order.take();
}

}  // namespace limitgauge::engine::strategy
