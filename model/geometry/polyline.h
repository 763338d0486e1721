#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/geometry/segment.h"

namespace limitgauge::model {

/// Which of `count` points of a polyline to keep so that every chord between kept neighbours i and
/// j passes `may_join(i, j)`: from each the longest chord that doubling and halving finds. Chords
/// of the polyline itself are taken to pass.
template <class MayJoin>
std::vector<std::size_t> reduce_chords(std::size_t count, const MayJoin& may_join) {
  std::vector<std::size_t> kept;
  if (count == 0) return kept;
  kept.push_back(0);
  for (std::size_t at = 0; at + 1 < count;) {
    const std::size_t last = count - 1;
    std::size_t good = at + 1, bad = last + 1;
    for (std::size_t stride = 2; good < last; stride *= 2) {
      const std::size_t next = std::min(at + stride, last);
      if (!may_join(at, next)) {
        bad = next;
        break;
      }
      good = next;
    }
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      (may_join(at, middle) ? good : bad) = middle;
    }
    kept.push_back(good);
    at = good;
  }
  return kept;
}

/// Leaves out points of a polyline of `Point`s so that it stays within `error_mm` of what it was,
/// measured from each point left out to the chord that replaces it (Douglas and Peucker).
/// `place(point)` is a Vec2 or a Vec3.
template <class Point, class Place>
std::vector<Point> reduced(const std::vector<Point>& line, double error_mm, const Place& place) {
  if (line.size() < 3) return line;
  const auto off = [&](std::size_t i, std::size_t a, std::size_t b) {
    return distance_to_segment(place(line[i]), place(line[a]), place(line[b]));
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

}  // namespace limitgauge::model
