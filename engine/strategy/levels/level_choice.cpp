#include "engine/strategy/levels/level_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

/// Bins of height a level distance.
constexpr double kBins = 8;
/// A place counts as level below this slope, and heights this share of the distance apart as one.
constexpr double kLevelSlope_rad = model::radians(1), kSameHeight = 0.02;

class Chooser {
 public:
  Chooser(const SlopeCells& slopes, const CellMask& cut, const CellMask& steep,
          const LevelRule& rule)
      : slopes_(slopes), cut_(cut), steep_(steep), rule_(rule) {}

  std::vector<double> choose() {
    find_range();
    if (low_ > high_) return {};
    fill_bins();
    std::vector<double> levels = feet();
    for (double z = high_ - way_down(high_) / 2; z > low_; z -= way_down(z)) levels.push_back(z);
    levels.push_back(low_);
    std::sort(levels.begin(), levels.end(), std::greater<>());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
  }

 private:
  void find_range() {
    for (std::size_t i = 0; i < cut_.set.size(); ++i) {
      if (!cut_.set[i]) continue;
      high_ = std::max(high_, slopes_.cells[i].high_mm);
      low_ = std::min(low_, slopes_.cells[i].low_mm);
    }
    low_ = std::max(low_, rule_.lowest_mm);
  }

  double bin_mm() const { return rule_.distance_mm / kBins; }
  std::size_t bin(double z) const {
    const double at = std::floor((std::clamp(z, low_, high_) - low_) / bin_mm());
    return std::min(sines_.size() - 1, static_cast<std::size_t>(at));
  }

  void fill_bins() {
    sines_.assign(1 + static_cast<std::size_t>((high_ - low_) / bin_mm()), 1.0);
    for (std::size_t i = 0; i < cut_.set.size(); ++i) {
      if (!cut_.set[i] || !steep_.set[i]) continue;
      const SlopeCell& cell = slopes_.cells[i];
      const double sine = std::sin(cell.slope_rad);
      for (std::size_t b = bin(cell.low_mm); b <= bin(cell.high_mm); ++b)
        sines_[b] = std::min(sines_[b], sine);
    }
  }

  double way_down(double from) const {
    double sine = 1;
    for (std::size_t b = bin(from - rule_.distance_mm); b <= bin(from); ++b)
      sine = std::min(sine, sines_[b]);
    return rule_.distance_mm * sine;
  }

  /// Heights of level places among what is cut, the highest of those that are as good as one.
  std::vector<double> feet() const {
    std::vector<double> heights;
    for (std::size_t i = 0; i < cut_.set.size(); ++i) {
      const SlopeCell& cell = slopes_.cells[i];
      if (cut_.set[i] && !steep_.set[i] && cell.slope_rad < kLevelSlope_rad && cell.low_mm >= low_)
        heights.push_back(cell.high_mm);
    }
    std::sort(heights.begin(), heights.end(), std::greater<>());
    const double same = kSameHeight * rule_.distance_mm;
    std::vector<double> chosen;
    for (const double z : heights)
      if (chosen.empty() || chosen.back() - z > same) chosen.push_back(z);
    return chosen;
  }

  const SlopeCells& slopes_;
  const CellMask& cut_;
  const CellMask& steep_;
  const LevelRule& rule_;
  double low_ = std::numeric_limits<double>::infinity(),
         high_ = -std::numeric_limits<double>::infinity();
  std::vector<double> sines_;
};

}  // namespace

std::vector<double> choose_levels(const SlopeCells& slopes, const CellMask& cut,
                                  const CellMask& steep, const LevelRule& rule) {
  return Chooser(slopes, cut, steep, rule).choose();
}

}  // namespace limitgauge::engine::strategy
