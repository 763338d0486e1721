#pragma once

#include <array>
#include <cstdint>

namespace limitgauge::simulator {

/// How the surface passes through a cell of eight lattice points, from the signs at its corners
/// alone. Corner k is at (k>>2 & 1, k>>1 & 1, k & 1); bit k of the signs is set where it stands in
/// the material. On each face the surface runs in segments between the face's edges that it
/// crosses; where two corners that stand are diagonal, each is cut off by a segment of its own.
/// Every crossed edge ends one segment on each of its two faces, so that the segments of a cell
/// close to cycles, each edge being in at most one.
struct CellCycles {
  static constexpr std::uint8_t kNone = 0xff;

  std::uint8_t count = 0;                  ///< of cycles, at most four
  std::array<std::uint8_t, 12> of_edge{};  ///< the cycle that an edge is in, kNone if not crossed
  /// Faces with two segments, both in one cycle; face 2a + s is the one across axis a on side s.
  std::uint8_t twice = 0;
};

/// Of the two axes that `axis` is not, the lower (`which` 0) or the higher one (1).
constexpr int other_axis(int axis, int which) {
  return which == 0 ? (axis == 0 ? 1 : 0) : (axis == 2 ? 1 : 2);
}

/// Edge along `axis` at place (u, v) in {0, 1}² on the other two axes, in ascending order of axes.
constexpr int cell_edge(int axis, int u, int v) {
  return axis * 4 + u * 2 + v;
}

/// The cycles for every set of signs.
const std::array<CellCycles, 256>& cell_cycles();

}  // namespace limitgauge::simulator
