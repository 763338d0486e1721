#pragma once

#include <cstddef>
#include <functional>

namespace limitgauge::simulator {

/// What a piece of work may take before its process is ended.
struct ProcessLimits {
  std::size_t memory_bytes = 0;  ///< beyond what this process has already
  unsigned cpu_seconds = 0;
  unsigned wall_seconds = 0;  ///< for work that waits for ever, on a lock that nobody gives back
};

/// Does `work` in a process of its own, which leaves no trace but the answer: true if it came to
/// its end, an exception of the standard library other than std::bad_alloc included; false if it
/// broke down, ran out of memory or took too long. For libraries that a broken file breaks. Throws
/// ResourceError where no process can be started.
bool comes_to_its_end(const std::function<void()>& work, const ProcessLimits& limits);

}  // namespace limitgauge::simulator
