#pragma once

#include <cstdint>

#include "simulator/grid/block_cut.h"

namespace limitgauge::simulator {

/// The least and the largest of a leaf's distances.
struct LeafRange {
  float least = 0, most = 0;
};
LeafRange value_range(const LeafDistances& distances);

/// What cutting a leaf did to its values.
struct LoweredLeaf {
  bool changed = false;  ///< some value rose
  float least = 0;       ///< of the values now
};
/// Raises each of a leaf's values to minus the distance where that is larger.
LoweredLeaf lower_values(const LeafDistances& distances, float* values);

/// One bit for each voxel of a leaf, 64 a word.
using LeafBits = std::array<std::uint64_t, LeafDistances{}.size() / 64>;
/// Which of a leaf's values are within the band.
LeafBits within_band(const float* values, float band);

}  // namespace limitgauge::simulator
