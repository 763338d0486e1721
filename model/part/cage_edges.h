#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::model {

/// One face's use of an edge: from the vertex of `corner` (an index into Cage::face_corners) to the
/// next corner of `face`. `low` and `high` are the two vertices in ascending order.
struct EdgeUse {
  Index low = 0, high = 0;
  Index corner = 0, next_corner = 0;
  Index face = 0;

  friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
};

/// The uses of all edges of a cage whose indices are in range, those of one edge side by side and
/// in the order of the faces.
std::vector<EdgeUse> sorted_edge_uses(const Cage& cage);

/// Calls `visit(std::span<const EdgeUse>)` once an edge.
template <typename Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit&& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low &&
           uses[end].high == uses[begin].high)
      ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace limitgauge::model
