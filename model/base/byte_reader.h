#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

namespace limitgauge::model {

/// The number of type T at the beginning of `bytes`, which are as many at least, in the stated byte
/// order.
template <class T>
T number_in(std::string_view bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::copy_n(bytes.data(), sizeof(T), raw.begin());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

}  // namespace limitgauge::model
