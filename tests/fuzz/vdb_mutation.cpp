#include "tests/fuzz/vdb_mutation.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <random>

namespace limitgauge::fuzz {
namespace {

/// A file in a room that it may grow in, and chance.
class Damage {
 public:
  Damage(std::span<std::uint8_t> room, std::size_t size, unsigned seed)
      : room_(room), size_(size), random_(seed) {}

  std::size_t size() const { return size_; }

  void damage() {
    switch (below(8)) {
      case 0:
        return put(extreme_integer<std::uint32_t>());
      case 1:
        return put(extreme_integer<std::uint64_t>());
      case 2:
        return put(extreme_real<float>());
      case 3:
        return put(extreme_real<double>());
      case 4:
        return cut_end();
      case 5:
        return repeat_block();
      case 6:
        return move_block();
      default:
        return empty_block();
    }
  }

 private:
  struct Block {
    std::size_t begin, size;
  };

  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  /// Short ones are as likely as long ones.
  Block block() {
    const std::size_t begin = below(size_);
    const std::size_t most = std::size_t{1} << below(14);
    return {begin, std::min(1 + below(most), size_ - begin)};
  }

  template <class T>
  T extreme_integer() {
    constexpr T kMost = std::numeric_limits<T>::max();
    const std::array<T, 12> values = {0,
                                      1,
                                      static_cast<T>(size_),
                                      static_cast<T>(size_ + 1),
                                      kMost,
                                      kMost - 1,
                                      kMost / 2,
                                      kMost / 2 + 1,
                                      kMost / 4 + 1,
                                      static_cast<T>(1'000'000'000),
                                      static_cast<T>(T{1} << below(8 * sizeof(T))),
                                      static_cast<T>(random_())};
    return values[below(values.size())];
  }

  template <class T>
  T extreme_real() {
    using Limits = std::numeric_limits<T>;
    const std::array<T, 9> values = {T{0},
                                     -T{0},
                                     Limits::quiet_NaN(),
                                     Limits::infinity(),
                                     -Limits::infinity(),
                                     Limits::max(),
                                     Limits::lowest(),
                                     Limits::denorm_min(),
                                     Limits::epsilon()};
    return values[below(values.size())];
  }

  /// Numbers of a .vdb stand at any byte, small ones near its begin most of all.
  template <class T>
  void put(T value) {
    if (size_ < sizeof value) return;
    constexpr std::size_t kDescriptions = 1500;
    const std::size_t places = size_ - sizeof value + 1;
    const std::size_t at = below(below(2) == 0 ? places : std::min(places, kDescriptions));
    std::memcpy(room_.data() + at, &value, sizeof value);
  }

  void cut_end() { size_ = std::max<std::size_t>(1, below(size_)); }

  void repeat_block() {
    const Block b = block();
    const std::size_t more = std::min(b.size, room_.size() - size_);
    const auto end = room_.begin() + static_cast<std::ptrdiff_t>(b.begin + b.size);
    std::copy_backward(end, at(size_), at(size_ + more));
    std::copy_n(at(b.begin), more, end);
    size_ += more;
  }

  void move_block() {
    const Block b = block();
    const std::size_t to = below(size_);
    const auto begin = at(b.begin), end = at(b.begin + b.size);
    if (to < b.begin)
      std::rotate(at(to), begin, end);
    else if (to > b.begin + b.size)
      std::rotate(begin, end, at(to));
  }

  void empty_block() {
    const Block b = block();
    if (below(2) == 0) {
      std::fill_n(at(b.begin), b.size, static_cast<std::uint8_t>(below(2) * 0xFF));
    } else if (b.size < size_) {
      std::copy(at(b.begin + b.size), at(size_), at(b.begin));
      size_ -= b.size;
    }
  }

  std::span<std::uint8_t>::iterator at(std::size_t place) {
    return room_.begin() + static_cast<std::ptrdiff_t>(place);
  }

  std::span<std::uint8_t> room_;
  std::size_t size_;
  std::mt19937 random_;
};

}  // namespace

std::size_t damage_vdb(std::span<std::uint8_t> room, std::size_t size, unsigned random) {
  if (size == 0) return 0;
  Damage damage(room, size, random);
  damage.damage();
  return damage.size();
}

}  // namespace limitgauge::fuzz
