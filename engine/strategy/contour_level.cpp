#include "engine/strategy/contour_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/strategy/reduce.h"

namespace limitgauge::engine::strategy {
namespace {

double largest_in(const Raster& raster, const std::vector<float>& field, const Window& w) {
  double largest = -std::numeric_limits<double>::infinity();
  for (int j = w.first_row; j <= w.last_row; ++j)
    for (int i = w.first_column; i <= w.last_column; ++i)
      largest = std::max(
          largest, static_cast<double>(field[static_cast<std::size_t>(j) * raster.columns + i]));
  return largest;
}

/// A closed line is cut at the point farthest from its first, so that reduction has two ends.
std::vector<FlatPoint> simplified(const Isoline& line, double error_mm) {
  return reduced(line.points, error_mm, [](const FlatPoint& p) { return std::pair(p.x, p.y); });
}

}  // namespace

ContourLevel::ContourLevel(const Raster& raster, const LevelField& field, const LoopRule& rule)
    : raster_(raster), window_(rule.window), slack_mm_(rule.slack_mm) {
  const double largest = largest_in(raster, field.clear_mm, rule.window);
  // With nothing to keep clear of, the loops start around the middle line, half a step out.
  const double first =
      field.anything_forbidden ? rule.reduction_mm + rule.slack_mm : rule.step_over_mm / 2;
  for (int k = 0; first + k * rule.step_over_mm <= largest; ++k) {
    auto group = isolines(raster, field.clear_mm, rule.window, first + k * rule.step_over_mm);
    for (Isoline& line : group) line.points = simplified(line, rule.reduction_mm);
    std::erase_if(group, [](const Isoline& line) { return line.points.size() < 2; });
    if (!group.empty()) groups_.push_back(std::move(group));
  }
  std::reverse(groups_.begin(), groups_.end());
  const int columns = window_.last_column - window_.first_column + 1;
  for (int j = window_.first_row; j <= window_.last_row; ++j) {
    const auto row = field.clear_mm.begin() + static_cast<std::ptrdiff_t>(j) * raster.columns;
    clear_mm_.insert(clear_mm_.end(), row + window_.first_column,
                     row + window_.first_column + columns);
  }
}

double ContourLevel::clear_at(const FlatPoint& p) const {
  const int columns = window_.last_column - window_.first_column + 1;
  const int rows = window_.last_row - window_.first_row + 1;
  const double u = std::clamp((p.x - raster_.x0) / raster_.pixel_mm - window_.first_column, 0.0,
                              static_cast<double>(columns - 1));
  const double v = std::clamp((p.y - raster_.y0) / raster_.pixel_mm - window_.first_row, 0.0,
                              static_cast<double>(rows - 1));
  const int i = std::min(static_cast<int>(u), columns - 2);
  const int j = std::min(static_cast<int>(v), rows - 2);
  const auto at = [&](int a, int b) {
    return static_cast<double>(clear_mm_[static_cast<std::size_t>(b) * columns + a]);
  };
  const double s = u - i, t = v - j;
  return (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) +
         (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t;
}

bool ContourLevel::clear_between(const FlatPoint& a, const FlatPoint& b) const {
  const int samples = 1 + static_cast<int>(std::ceil(2 * distance(a, b) / raster_.pixel_mm));
  for (int k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples;
    if (clear_at({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}) < slack_mm_) return false;
  }
  return true;
}

}  // namespace limitgauge::engine::strategy
