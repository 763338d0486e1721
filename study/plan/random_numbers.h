#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace limitgauge::study {

/// Numbers that are the same for the same seed with every compiler and library, which the
/// distributions of <random> are not: SplitMix64 (Steele, Lea, Flood 2014).
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// From 0 to 1, 1 excluded.
  double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// From 0 to `count`, `count` excluded, each alike.
  std::size_t below(std::size_t count) {
    const std::uint64_t n = count;
    const std::uint64_t uneven = (0 - n) % n;  // numbers that would come up once too often
    for (;;) {
      const std::uint64_t drawn = next();
      if (drawn >= uneven) return static_cast<std::size_t>(drawn % n);
    }
  }

  template <class T>
  void shuffle(std::vector<T>& all) {
    for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace limitgauge::study
