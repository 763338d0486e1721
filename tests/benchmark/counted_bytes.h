#pragma once

#include <cstddef>

namespace limitgauge::benchmarks {

/// Bytes that operator new has handed out in this executable and not got back, as the allocator
/// rounds them.
std::size_t counted_bytes();

}  // namespace limitgauge::benchmarks
