#pragma once
// Stock as heights over a grid of places, cut by a flat cutter in small steps.

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/part/stock.h"

namespace limitgauge::test {

class StockHeights {
 public:
  StockHeights(const model::Stock& stock, double spacing_mm)
      : box_(model::bounding_box(stock)), spacing_(spacing_mm) {
    columns_ = 1 + static_cast<int>(box_.size().x / spacing_);
    rows_ = 1 + static_cast<int>(box_.size().y / spacing_);
    heights_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                    box_.high.z);
  }

  /// A flat cutter's tip moves straight from `a` to `b`.
  void cut(const model::Vec3& a, const model::Vec3& b, double radius_mm) {
    visit(a, b, radius_mm, [](double& height, double tip) { height = std::min(height, tip); });
  }
  /// Highest place under the cutter on its way; far below where there is no stock.
  double highest_mm(const model::Vec3& a, const model::Vec3& b, double radius_mm) {
    double highest = box_.low.z - 1e3;
    visit(a, b, radius_mm, [&](double& height, double) { highest = std::max(highest, height); });
    return highest;
  }

 private:
  template <class Visit>
  void visit(const model::Vec3& a, const model::Vec3& b, double radius, const Visit& visit) {
    const int steps = 1 + static_cast<int>(distance(a, b) / spacing_);
    for (int k = 0; k <= steps; ++k) {
      const model::Vec3 tip = lerp(a, b, static_cast<double>(k) / steps);
      const auto first = [&](double at, double low) {
        return std::max(0, static_cast<int>(std::ceil((at - radius - low) / spacing_)));
      };
      for (int j = first(tip.y, box_.low.y); j < rows_ && y(j) <= tip.y + radius; ++j)
        for (int i = first(tip.x, box_.low.x); i < columns_ && x(i) <= tip.x + radius; ++i)
          if (std::hypot(x(i) - tip.x, y(j) - tip.y) <= radius)
            visit(heights_[static_cast<std::size_t>(j) * columns_ + i], tip.z);
    }
  }
  double x(int i) const { return box_.low.x + i * spacing_; }
  double y(int j) const { return box_.low.y + j * spacing_; }

  model::Box3 box_;
  double spacing_;
  int columns_ = 0, rows_ = 0;
  std::vector<double> heights_;
};

}  // namespace limitgauge::test
