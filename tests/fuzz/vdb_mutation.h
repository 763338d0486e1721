#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace limitgauge::fuzz {

/// Damages the file of `size` bytes that `room` begins with, as what `random` says: a number (a
/// length, an offset, a distance) becomes an extreme one; a block comes twice, is moved, is emptied
/// or goes missing; the end is cut off. Returns the new size, which is that of `room` at most.
std::size_t damage_vdb(std::span<std::uint8_t> room, std::size_t size, unsigned random);

}  // namespace limitgauge::fuzz
