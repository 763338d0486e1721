#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {

inline double distance_to_chord(const model::Vec3& p, const model::Vec3& a, const model::Vec3& b) {
  const model::Vec3 along = b - a;
  const double l2 = length_squared(along);
  const double t = l2 > 0 ? std::clamp(dot(p - a, along) / l2, 0.0, 1.0) : 0.0;
  return distance(p, a + along * t);
}

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

}  // namespace limitgauge::engine::strategy
