#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace limitgauge::engine::strategy {

/// A part of a polyline; what lies between two of its own points is straight.
template <class Point>
using Polyline = std::vector<Point>;

/// The runs of `line` on which `inside(point)` holds, in its order. Between points it is asked for
/// at steps of at most `spacing_mm` (parts shorter than that may be missed), and a change is placed
/// within a millionth of a step. `at(a, b, t)` gives the point a + (b - a) t, `apart(a, b)` the
/// distance that counts for the steps.
template <class Point, class Inside, class At, class Apart>
std::vector<Polyline<Point>> clipped(const Polyline<Point>& line, double spacing_mm,
                                     const Inside& inside, const At& at, const Apart& apart) {
  std::vector<Polyline<Point>> runs;
  bool in = false;
  const auto change = [&](const Point& a, const Point& b, double low, double high) {
    constexpr int kHalvings = 20;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (inside(at(a, b, middle)) == in ? low : high) = middle;
    }
    // On the side that is inside.
    const Point place = at(a, b, in ? low : high);
    if (!in) runs.emplace_back();
    runs.back().push_back(place);
    in = !in;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i == 0) {
      if ((in = inside(line[0]))) runs.push_back({line[0]});
      continue;
    }
    const Point &a = line[i - 1], &b = line[i];
    const int steps = 1 + static_cast<int>(std::ceil(apart(a, b) / spacing_mm));
    for (int k = 1; k <= steps; ++k)
      if (inside(at(a, b, static_cast<double>(k) / steps)) != in)
        change(a, b, static_cast<double>(k - 1) / steps, static_cast<double>(k) / steps);
    if (in) runs.back().push_back(b);
  }
  return runs;
}

}  // namespace limitgauge::engine::strategy
