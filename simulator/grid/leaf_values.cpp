#include "simulator/grid/leaf_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "simulator/sweep/vector_loops.h"

namespace limitgauge::simulator {
namespace {

constexpr std::size_t kVoxels = LeafDistances{}.size();
constexpr std::size_t kLanes = 16;

// Lane by lane, so that no order of the comparisons is asked for.
LIMITGAUGE_WIDE
void find_range(const float* values, float* least, float* most) {
  for (std::size_t k = 0; k < kLanes; ++k) least[k] = most[k] = values[k];
  for (std::size_t n = kLanes; n < kVoxels; n += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k) {
      const float v = values[n + k];
      least[k] = v < least[k] ? v : least[k];
      most[k] = v > most[k] ? v : most[k];
    }
}

LIMITGAUGE_WIDE
void lower_lanes(const float* __restrict distances, float* __restrict values,
                 float* __restrict least, std::uint32_t* __restrict changed) {
  for (std::size_t n = 0; n < kVoxels; n += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k) {
      const float before = values[n + k], cut = -distances[n + k];
      const float after = cut > before ? cut : before;
      changed[k] |= cut > before ? 1U : 0U;
      values[n + k] = after;
      least[k] = after < least[k] ? after : least[k];
    }
}

LIMITGAUGE_WIDE
void mark_bytes(const float* __restrict values, float band, std::uint8_t* __restrict marks) {
  for (std::size_t n = 0; n < kVoxels; ++n) marks[n] = std::abs(values[n]) < band ? 1 : 0;
}

// Moves bit 0 of byte k to bit k of the highest byte, for all eight at once.
std::uint64_t eight_bits(const std::uint8_t* marks) {
  std::uint64_t bits = 0;
  for (unsigned k = 0; k < 8; ++k) bits |= std::uint64_t{marks[k]} << (8 * k);
  return (bits * 0x0102040810204080U) >> 56;
}

}  // namespace

LeafRange value_range(const LeafDistances& distances) {
  std::array<float, kLanes> least, most;
  find_range(distances.data(), least.data(), most.data());
  return {*std::min_element(least.begin(), least.end()),
          *std::max_element(most.begin(), most.end())};
}

LoweredLeaf lower_values(const LeafDistances& distances, float* values) {
  std::array<float, kLanes> least;
  std::array<std::uint32_t, kLanes> changed{};
  least.fill(values[0] > -distances[0] ? values[0] : -distances[0]);
  lower_lanes(distances.data(), values, least.data(), changed.data());
  return {std::any_of(changed.begin(), changed.end(), [](auto c) { return c != 0; }),
          *std::min_element(least.begin(), least.end())};
}

LeafBits within_band(const float* values, float band) {
  std::array<std::uint8_t, kVoxels> marks;
  mark_bytes(values, band, marks.data());
  LeafBits bits{};
  for (std::size_t n = 0; n < kVoxels; n += 8) bits[n / 64] |= eight_bits(&marks[n]) << (n % 64);
  return bits;
}

}  // namespace limitgauge::simulator
