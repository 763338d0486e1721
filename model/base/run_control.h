#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace limitgauge::model {

/// What a long computation is told from outside: how many threads it may use, whether to stop,
/// and whom to tell how far it is. Results never depend on it.
struct RunControl {
  unsigned threads = 1;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double fraction)> progress = {};  ///< called from any thread, 0 to 1

  /// Throws Interrupted when a stop was asked for. Cheap: call it once a block of work.
  void check() const;
  void report(double fraction) const {
    if (progress) progress(fraction);
  }
};

/// Calls `body(i)` for i in [0, count) on up to `threads` threads, in chunks taken in order.
/// Serial where one thread or one item makes it so. The first exception thrown is rethrown after
/// all threads have ended. `body` must write only to places of its own index, so that the result
/// is the same for any number of threads.
void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& body);

}  // namespace limitgauge::model
