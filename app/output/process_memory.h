#pragma once

#include <cstdint>

namespace limitgauge::app {

/// From now on the peak counts anew, where the kernel lets us say so.
void reset_process_peak();
/// Most memory that this process had in use since then; 0 where the kernel does not say.
std::uint64_t process_peak_bytes();

}  // namespace limitgauge::app
