#include "engine/strategy/levels/level_loops.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/strategy/raster/clip.h"
#include "engine/strategy/raster/swept_raster.h"
#include "model/geometry/polyline.h"

namespace limitgauge::engine::strategy {
namespace {

class LoopMaker {
 public:
  LoopMaker(const LevelSpace& space, const StockOutline& outline, const LoopRule& rule)
      : space_(space),
        outline_(outline),
        rule_(rule),
        raster_(space.raster()),
        half_diagonal_(raster_.pixel_mm / std::numbers::sqrt2),
        sure_radius_(rule.cut_radius_mm - half_diagonal_),
        cleared_(raster_, spared_pixels(space, rule)),
        window_(covering(raster_, rule.stock)) {}

  std::vector<std::vector<Isoline>> run() {
    if (!space_.anything_forbidden()) return rows();
    place_loops();
    fill_gaps();
    fill_places();
    std::vector<std::vector<Isoline>> groups;
    for (auto gap = gaps_.rbegin(); gap != gaps_.rend(); ++gap) {
      if (!gap->loops.empty()) groups.push_back(std::move(gap->loops));
      if (!gap->leftovers.empty()) groups.push_back(std::move(gap->leftovers));
    }
    return groups;
  }

 private:
  /// What lies between the loops of two values: those of the lower one, and what clears the rest.
  struct Gap {
    std::vector<Isoline> loops, leftovers;
  };

  /// With nothing to go round, straight rows from edge to edge along the longer side, each its own
  /// group: what is still to be cut lies on their right.
  std::vector<std::vector<Isoline>> rows() {
    const model::Vec3 low = rule_.stock.low, size = rule_.stock.size();
    const bool wide = size.x >= size.y;
    const double along = wide ? size.x : size.y, across = wide ? size.y : size.x;
    const int count = std::max(1, static_cast<int>(std::ceil(across / rule_.spacing_mm)));
    const auto in_stock = [&](const FlatPoint& p) { return outline_.distance_mm(p) <= 0; };
    std::vector<std::vector<Isoline>> groups(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      const double shift = across * (wide ? count - k - 0.5 : k + 0.5) / count;
      std::vector<FlatPoint> row;
      for (const double way : {0.0, along / 2, along})
        row.push_back(wide ? FlatPoint{low.x + way, low.y + shift}
                           : FlatPoint{low.x + shift, low.y + way});
      Isoline line{std::move(row), false};
      keep(line, in_stock, rule_.error_mm, groups[static_cast<std::size_t>(k)]);
    }
    visit_left([&](int i, int j) {
      add({{{raster_.x(i), raster_.y(j)}}, false}, groups.emplace_back());
    });
    return groups;
  }

  /// Value of the loops that begin gap `k`. The first is a border on the fine raster, from which
  /// the coarse one's distances differ by up to a diagonal of its pixels.
  double value(int k) const {
    if (k == 0) return rule_.border_mm;
    return rule_.border_mm - 2 * half_diagonal_ + k * rule_.spacing_mm;
  }

  void place_loops() {
    double largest = 0;
    for (int j = window_.first_row; j <= window_.last_row; ++j)
      for (int i = window_.first_column; i <= window_.last_column; ++i)
        largest = std::max(largest, static_cast<double>(clear(i, j)));
    gaps_.resize(1);
    add_border();
    for (int k = 1; value(k) <= largest; ++k) {
      gaps_.resize(static_cast<std::size_t>(k) + 1);
      add_loops(gaps_.back().loops, value(k),
                [&](const FlatPoint& p) { return outline_.distance_mm(p) <= raster_.pixel_mm; });
    }
  }

  float clear(int i, int j) const {
    return space_.clear_mm()[static_cast<std::size_t>(j) * raster_.columns + i];
  }

  void add_border() {
    const NearField& near = space_.near();
    if (near.clear_mm.empty()) return;
    const double sight = rule_.cut_radius_mm + near.raster.pixel_mm;
    const Window window = covering(near.raster, rule_.stock.grown(sight));
    const auto touches_stock = [&](const FlatPoint& p) {
      return outline_.distance_mm(p) <= rule_.cut_radius_mm;
    };
    for (Isoline& line : isolines(near.raster, near.clear_mm, window, rule_.border_mm))
      keep(line, touches_stock, rule_.border_error_mm, gaps_.front().loops);
  }

  template <class Wanted>
  void add_loops(std::vector<Isoline>& to, double at_value, const Wanted& wanted) {
    for (Isoline& line : isolines(raster_, space_.clear_mm(), window_, at_value))
      keep(line, wanted, rule_.error_mm, to);
  }

  /// The wanted runs of `line`, less the points that may be left out.
  template <class Wanted>
  void keep(Isoline& line, const Wanted& wanted, double error_mm, std::vector<Isoline>& to) {
    const auto outside = std::find_if_not(line.points.begin(), line.points.end(), wanted);
    if (outside == line.points.end()) {
      add({simplified(line.points, error_mm), line.closed}, to);
      return;
    }
    if (line.closed) {
      line.points.pop_back();
      std::rotate(line.points.begin(), outside, line.points.end());
      line.points.push_back(line.points.front());
    }
    const auto at = [](const FlatPoint& a, const FlatPoint& b, double t) { return lerp(a, b, t); };
    for (const auto& run :
         clipped(line.points, raster_.pixel_mm, wanted, at,
                 [](const FlatPoint&a, const FlatPoint&b) { return distance(a, b); }))
      add({simplified(run, error_mm), false}, to);
  }

  static std::vector<FlatPoint> simplified(const std::vector<FlatPoint>& line, double error_mm) {
    return model::reduced(line, error_mm, [](const FlatPoint& p) { return model::Vec2{p.x, p.y}; });
  }

  void add(Isoline line, std::vector<Isoline>& to) {
    cleared_.sweep(line.points, sure_radius_);
    to.push_back(std::move(line));
  }

  /// Which loops a pixel lies just inside of.
  std::size_t gap_of(double clear_mm) const {
    if (clear_mm < value(1)) return 0;
    const auto k = 1 + static_cast<std::size_t>((clear_mm - value(1)) / rule_.spacing_mm);
    return std::min(k, gaps_.size() - 1);
  }

  /// Loops half way between, where something is left within a pass's reach: a way straight down
  /// the field from there meets them.
  void fill_gaps() {
    std::vector<std::vector<FlatPoint>> left(gaps_.size());
    visit_left([&](int i, int j) {
      left[gap_of(clear(i, j))].push_back({raster_.x(i), raster_.y(j)});
    });
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (left[k].empty()) continue;
      SweptRaster sight(raster_, std::vector<std::uint8_t>(raster_.size(), 0));
      for (const FlatPoint& p : left[k]) sight.sweep(p, p, rule_.cut_radius_mm);
      const int gap = static_cast<int>(k);
      add_loops(gaps_[k].leftovers, (value(gap) + value(gap + 1)) / 2,
                [&](const FlatPoint& p) { return sight.is_swept(p, p, half_diagonal_); });
    }
  }

  /// What even those have left: single places, one after the other.
  void fill_places() {
    visit_left([&](int i, int j) {
      add({{{raster_.x(i), raster_.y(j)}}, false}, gaps_[gap_of(clear(i, j))].leftovers);
    });
  }

  template <class Visit>
  void visit_left(const Visit& visit) const {
    for (int j = 0; j < raster_.rows; ++j)
      for (int i = 0; i < raster_.columns; ++i)
        if (!cleared_.flags()[static_cast<std::size_t>(j) * raster_.columns + i]) visit(i, j);
  }

  const LevelSpace& space_;
  const StockOutline& outline_;
  const LoopRule& rule_;
  const Raster& raster_;
  double half_diagonal_, sure_radius_;
  SweptRaster cleared_;
  Window window_;
  std::vector<Gap> gaps_;  ///< innermost first
};

}  // namespace

std::vector<std::uint8_t> spared_pixels(const LevelSpace& space, const LoopRule& rule) {
  std::vector<std::uint8_t> spared(rule.stock_pixels.size());
  for (std::size_t i = 0; i < spared.size(); ++i)
    spared[i] = !rule.stock_pixels[i] ||
                (space.anything_forbidden() && space.clear_mm()[i] < rule.border_mm);
  return spared;
}

std::vector<std::vector<Isoline>> level_loops(const LevelSpace& space, const StockOutline& outline,
                                              const LoopRule& rule) {
  return LoopMaker(space, outline, rule).run();
}

}  // namespace limitgauge::engine::strategy
