#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace limitgauge::engine::strategy {

/// Leaves out points of a polyline of two-dimensional `Point`s so that it stays within `error_mm`
/// of what it was, measured from each point left out to the chord that replaces it (Douglas and
/// Peucker). `xy(point)` gives a point's two coordinates as a pair.
template <class Point, class Coordinates>
std::vector<Point> reduced(const std::vector<Point>& line, double error_mm, const Coordinates& xy) {
  if (line.size() < 3) return line;
  const auto off = [&](std::size_t i, std::size_t a, std::size_t b) {
    const auto [px, py] = xy(line[i]);
    const auto [ax, ay] = xy(line[a]);
    const auto [bx, by] = xy(line[b]);
    const double dx = bx - ax, dy = by - ay, l2 = dx * dx + dy * dy;
    const double t =
        l2 > 0 ? std::fmin(1.0, std::fmax(0.0, ((px - ax) * dx + (py - ay) * dy) / l2)) : 0.0;
    return std::hypot(px - ax - t * dx, py - ay - t * dy);
  };
  std::vector<char> keep(line.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double farthest = error_mm;
    std::size_t split = a;
    for (std::size_t i = a + 1; i < b; ++i)
      if (const double d = off(i, a, b); d > farthest) {
        farthest = d;
        split = i;
      }
    if (split == a) continue;
    keep[split] = 1;
    open.push_back({a, split});
    open.push_back({split, b});
  }
  std::vector<Point> kept;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (keep[i]) kept.push_back(line[i]);
  return kept;
}

}  // namespace limitgauge::engine::strategy
