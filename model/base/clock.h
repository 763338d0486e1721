#pragma once

#include <chrono>
#include <string>

namespace limitgauge::model {

/// Seconds of wall time since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The time as ISO 8601, UTC, to the second: what stands in results as `created`.
std::string now_utc();

}  // namespace limitgauge::model
