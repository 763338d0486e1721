#pragma once

#include <array>

#include "simulator/grid/block_cut.h"
#include "simulator/grid/lattice.h"

namespace limitgauge::simulator {

/// Values at a leaf's voxels and at the first ones beyond its upper faces, z fastest.
inline constexpr int kPatchEdge = kLeafEdge + 1;
using LeafPatch = std::array<float, kPatchEdge * kPatchEdge * kPatchEdge>;

/// Where the net finds its values: leaves that take in the lowest corner of every cell whose
/// corners have different signs.
class NetSource {
 public:
  virtual ~NetSource() = default;
  virtual std::size_t leaves() const = 0;
  virtual Index3 corner(std::size_t leaf) const = 0;
  virtual void values(std::size_t leaf, LeafPatch& patch) const = 0;
};

}  // namespace limitgauge::simulator
