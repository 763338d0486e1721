#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace limitgauge::app {

/// Bytes `first` to `last`, both of them among it.
struct ByteRange {
  std::uint64_t first = 0, last = 0;
  std::uint64_t bytes() const { return last - first + 1; }
  friend bool operator==(const ByteRange&, const ByteRange&) = default;
};

/// More ranges than that are asked for by nobody who wants them; each costs a head of its own.
constexpr std::size_t kMostRanges = 16;

/// What a Range field (RFC 9110, 14.2) asks for of a file of `bytes` bytes. Nothing where it says
/// nothing that is heeded (another unit, not well written, last before first, more than
/// kMostRanges): then the answer is the whole file. None where no byte of what it asks for is
/// there. Ranges that overlap or touch are made one, so that no byte is among it twice; the others
/// keep their order.
std::optional<std::vector<ByteRange>> ranges_of(std::string_view field, std::uint64_t bytes);

}  // namespace limitgauge::app
