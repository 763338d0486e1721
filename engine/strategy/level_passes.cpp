#include "engine/strategy/level_passes.h"

#include <algorithm>
#include <limits>

#include "engine/strategy/swept_raster.h"

namespace limitgauge::engine::strategy {
namespace {

/// How far outside the stock the cutter comes down beyond touching it, mm.
constexpr double kOutside_mm = 0.5;

class PassOrder {
 public:
  PassOrder(const LevelSpace& space, const StockOutline& outline, const LoopRule& loops,
            const PassRule& rule)
      : space_(space),
        outline_(outline),
        rule_(rule),
        at_{loops.stock.low.x, loops.stock.low.y},
        cleared_(space.raster(), without_stock(loops)) {}

  void add_group(std::vector<Isoline> group) {
    if (rule_.direction == CutDirection::conventional)
      for (Isoline& line : group) std::reverse(line.points.begin(), line.points.end());
    while (!group.empty()) {
      const Start start = nearest(group);
      add(turned(std::move(group[start.line]), start.point));
      group.erase(group.begin() + static_cast<std::ptrdiff_t>(start.line));
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

  Start nearest(const std::vector<Isoline>& group) const {
    Start best;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t line, std::size_t point) {
      const double d = distance(group[line].points[point], at_);
      if (d >= least) return;
      least = d;
      best = {line, point};
    };
    for (std::size_t k = 0; k < group.size(); ++k) {
      const std::size_t count = group[k].points.size();
      look(k, 0);
      if (group[k].closed)
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
  for (auto& group : groups) order.add_group(std::move(group));
  return order.take();
}

}  // namespace limitgauge::engine::strategy
