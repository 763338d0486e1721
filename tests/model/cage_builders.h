#pragma once

#include <initializer_list>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::model::test {

/// A cage of given faces; its vertices lie on the moment curve, so that no two coincide.
inline Cage cage_of(Index vertices, std::initializer_list<std::vector<Index>> faces) {
  Cage cage;
  for (Index v = 0; v < vertices; ++v) {
    const double t = v;
    cage.vertices.push_back({t, t * t, t * t * t});
  }
  for (const std::vector<Index>& face : faces) cage.add_face(face);
  return cage;
}

/// A flat grid of columns x rows quads of 1 mm.
inline Cage grid(Index columns, Index rows) {
  Cage cage;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i <= columns; ++i)
      cage.vertices.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  }
  const Index row = columns + 1;
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index v = j * row + i;
      cage.add_face(std::vector<Index>{v, v + 1, v + row + 1, v + row});
    }
  }
  return cage;
}

/// The cube [-1, 1]^3, faces counter-clockwise from outside.
inline Cage cube() {
  Cage cage;
  for (Index v = 0; v < 8; ++v)
    cage.vertices.push_back({v & 1 ? 1.0 : -1.0, v & 2 ? 1.0 : -1.0, v & 4 ? 1.0 : -1.0});
  for (const std::vector<Index>& face : {std::vector<Index>{0, 2, 3, 1},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 4, 6, 2},
                                         {1, 3, 7, 5}})
    cage.add_face(face);
  return cage;
}

}  // namespace limitgauge::model::test
