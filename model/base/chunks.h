#pragma once

#include <algorithm>
#include <cstddef>

#include "model/base/run_control.h"

namespace limitgauge::model {

inline std::size_t chunk_count(std::size_t count, std::size_t chunk_size) {
  return (count + chunk_size - 1) / chunk_size;
}

/// Calls `body(begin, end)` for the ranges of up to `chunk_size` that [0, count) is cut into, on
/// the threads of `control`, each time after asking whether to stop. What a body keeps from one
/// index to the next, it keeps within a range only, so that results are the same for any number of
/// threads; otherwise as parallel_for.
template <class Body>
void parallel_chunks(std::size_t count, std::size_t chunk_size, const RunControl& control,
                     const Body& body) {
  parallel_for(chunk_count(count, chunk_size), control.threads, [&](std::size_t chunk) {
    control.check();
    const std::size_t begin = chunk * chunk_size;
    body(begin, std::min(count, begin + chunk_size));
  });
}

}  // namespace limitgauge::model
