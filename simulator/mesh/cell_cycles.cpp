#include "simulator/mesh/cell_cycles.h"

#include <vector>

namespace limitgauge::simulator {
namespace {

using Corner = std::array<int, 3>;

bool stands(unsigned signs, const Corner& c) {
  return signs >> (c[0] * 4 + c[1] * 2 + c[2]) & 1;
}

// The edge between two corners that differ along one axis.
int edge_between(const Corner& a, const Corner& b) {
  int axis = 0;
  while (a[axis] == b[axis]) ++axis;
  return cell_edge(axis, a[other_axis(axis, 0)], a[other_axis(axis, 1)]);
}

struct Segment {
  int edges[2];
  int face;
};

// Segments on one face: about each standing corner of a face of diagonal ones, otherwise from the
// one crossed edge to the other.
void add_segments(unsigned signs, int face, std::vector<Segment>& segments) {
  const int axis = face / 2, u = other_axis(axis, 0), v = other_axis(axis, 1);
  Corner ring[4];
  bool in[4];
  int crossed = 0;
  for (int k = 0; k < 4; ++k) {
    ring[k][axis] = face % 2, ring[k][u] = k == 1 || k == 2, ring[k][v] = k >= 2;
    in[k] = stands(signs, ring[k]);
  }
  int edges[4] = {};
  for (int k = 0; k < 4; ++k)
    if (in[k] != in[(k + 1) % 4]) edges[crossed++] = edge_between(ring[k], ring[(k + 1) % 4]);
  if (crossed == 2) segments.push_back({{edges[0], edges[1]}, face});
  if (crossed < 4) return;
  for (int k = 0; k < 4; ++k)
    if (in[k])
      segments.push_back(
          {{edge_between(ring[k], ring[(k + 1) % 4]), edge_between(ring[k], ring[(k + 3) % 4])},
           face});
}

CellCycles trace(unsigned signs) {
  std::vector<Segment> segments;
  for (int face = 0; face < 6; ++face) add_segments(signs, face, segments);
  CellCycles cell;
  cell.of_edge.fill(CellCycles::kNone);
  for (const Segment& first : segments) {
    if (cell.of_edge[first.edges[0]] != CellCycles::kNone) continue;
    cell.of_edge[first.edges[0]] = cell.count;
    // Few segments: spread along them until nothing is added.
    for (bool grown = true; grown;) {
      grown = false;
      for (const Segment& s : segments)
        for (int k = 0; k < 2; ++k)
          if (cell.of_edge[s.edges[k]] == cell.count &&
              cell.of_edge[s.edges[1 - k]] == CellCycles::kNone)
            cell.of_edge[s.edges[1 - k]] = cell.count, grown = true;
    }
    ++cell.count;
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (segments[i].face == segments[j].face &&
          cell.of_edge[segments[i].edges[0]] == cell.of_edge[segments[j].edges[0]])
        cell.twice = static_cast<std::uint8_t>(cell.twice | 1U << segments[i].face);
  return cell;
}

}  // namespace

const std::array<CellCycles, 256>& cell_cycles() {
  static const std::array<CellCycles, 256> all = [] {
    std::array<CellCycles, 256> cells;
    for (unsigned signs = 0; signs < 256; ++signs) cells[signs] = trace(signs);
    return cells;
  }();
  return all;
}

}  // namespace limitgauge::simulator
