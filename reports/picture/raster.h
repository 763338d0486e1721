#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace limitgauge::reports {

/// A point on the screen: x right and y down in pixels, the nearer the greater z.
struct ScreenPoint {
  double x = 0, y = 0, z = 0;
};

/// What is nearest at each pixel so far, of a screen or of some rows of it.
class DepthBuffer {
 public:
  /// Pixels are counted from the left of row `first_row` of the screen on.
  DepthBuffer(int width, int height, int first_row = 0)
      : width_(width),
        height_(height),
        first_row_(first_row),
        depth_(std::size_t(width) * height, -std::numeric_limits<float>::infinity()) {}
  /// Begins anew with `height` rows from `first_row` on, in the same memory.
  void restart(int first_row, int height) {
    first_row_ = first_row, height_ = height;
    depth_.assign(std::size_t(width_) * height, -std::numeric_limits<float>::infinity());
  }
  int width() const { return width_; }
  int height() const { return height_; }
  int first_row() const { return first_row_; }
  /// Of a place on the screen; none outside its rows.
  std::optional<std::size_t> pixel_at(int x, int y) const {
    y -= first_row_;
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return std::nullopt;
    return std::size_t(y) * width_ + x;
  }
  bool is_empty(std::size_t pixel) const { return std::isinf(depth_[pixel]); }
  /// z of what is nearest there.
  double nearest(std::size_t pixel) const { return depth_[pixel]; }

  /// Calls `paint(pixel, weights)` for each pixel whose centre lies in the triangle where it is
  /// nearer than all before; `weights` are the barycentric coordinates on the screen, which are
  /// those in space in a parallel view: see in_space. Either orientation.
  template <typename Paint>
  void fill_triangle(const std::array<ScreenPoint, 3>& t, Paint&& paint);

 private:
  int width_, height_, first_row_;
  std::vector<float> depth_;
};

/// How many rows of a picture are drawn at a time: what they hold stays in a processor's cache.
/// Even, since two of them become one that is shown.
inline constexpr int kRowsAtOnce = 64;

/// Calls `draw(first_row, rows)` for some rows of a picture after the other, so that not all of it
/// is held many times as fine as it is shown.
template <typename Draw>
void by_rows(int height, Draw&& draw) {
  for (int row = 0; row < height; row += kRowsAtOnce)
    draw(row, std::min(kRowsAtOnce, height - row));
}

/// Barycentric coordinates on the screen as those in space, of a triangle in perspective whose z
/// are inverse distances.
inline std::array<double, 3> in_space(const std::array<double, 3>& on_screen,
                                      const std::array<ScreenPoint, 3>& t) {
  const double a = on_screen[0] * t[0].z, b = on_screen[1] * t[1].z, c = on_screen[2] * t[2].z;
  const double sum = a + b + c;
  return {a / sum, b / sum, c / sum};
}

template <typename Paint>
void DepthBuffer::fill_triangle(const std::array<ScreenPoint, 3>& t, Paint&& paint) {
  const auto& [a, b, c] = t;
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0) return;
  const auto first = [](double low, int least) {
    return std::max(least, int(std::ceil(low - 0.5)));
  };
  const auto last = [](double high, int end) {
    return std::min(end - 1, int(std::floor(high - 0.5)));
  };
  const int y0 = first(std::min({a.y, b.y, c.y}), first_row_),
            y1 = last(std::max({a.y, b.y, c.y}), first_row_ + height_);
  if (y0 > y1) return;
  const int x0 = first(std::min({a.x, b.x, c.x}), 0), x1 = last(std::max({a.x, b.x, c.x}), width_);
  // Each weight is linear along a row.
  const double inverse = 1 / area;
  const double b_step = (c.y - a.y) * inverse, c_step = (a.y - b.y) * inverse;
  for (int y = y0; y <= y1; ++y) {
    const double py = y + 0.5 - a.y, ax = a.x;
    const double b_row = -(c.x - ax) * py * inverse, c_row = (b.x - ax) * py * inverse;
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5 - ax;
      const double wb = b_row + px * b_step, wc = c_row + px * c_step, wa = 1 - wb - wc;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const auto z = static_cast<float>(wa * a.z + wb * b.z + wc * c.z);
      const std::size_t pixel = std::size_t(y - first_row_) * width_ + x;
      if (z <= depth_[pixel]) continue;
      depth_[pixel] = z;
      paint(pixel, std::array<double, 3>{wa, wb, wc});
    }
  }
}

}  // namespace limitgauge::reports
