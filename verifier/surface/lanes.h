#pragma once

#include <array>
#include <cstddef>
#include <cstring>

namespace limitgauge::verifier {

/// Two numbers that are worked out at once, as every x86-64 can: GCC 12 leaves loops over control
/// points that look for a least or a greatest one by one. Each is rounded as if it were alone.
using Lanes = double __attribute__((vector_size(16)));

/// Two neighbours of a list, from `k` on.
template <std::size_t kCount>
Lanes lanes_at(const std::array<double, kCount>& list, int k) {
  Lanes out;
  std::memcpy(&out, list.data() + k, sizeof out);
  return out;
}
/// As std::min and std::max of each.
inline Lanes lesser(Lanes a, Lanes b) {
  return b < a ? b : a;
}
inline Lanes greater(Lanes a, Lanes b) {
  return a < b ? b : a;
}

}  // namespace limitgauge::verifier
