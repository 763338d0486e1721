#include "model/base/run_control.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "model/base/error.h"

namespace limitgauge::model {

void RunControl::check() const {
  if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw Interrupted();
}

namespace {

/// Threads that are waited for, however the scope is left.
class Threads {
 public:
  Threads() = default;
  ~Threads() {
    for (std::thread& thread : threads_) thread.join();
  }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  void start(const std::function<void()>& work) { threads_.emplace_back(work); }

 private:
  std::vector<std::thread> threads_;
};

/// Throws ResourceError where the system has no thread left; those that were started go on.
void start(Threads& pool, std::size_t count, const std::function<void()>& work) {
  try {
    for (std::size_t t = 0; t < count; ++t) pool.start(work);
  } catch (const std::system_error& error) {
    throw ResourceError("limitgauge: error: no thread can be started: " + error.code().message() +
                        "; fewer of them (--threads) or a higher limit would do");
  }
}

}  // namespace

void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& body) {
  const std::size_t workers = std::min<std::size_t>(std::max(1U, threads), count);
  if (workers <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    Threads pool;
    try {
      start(pool, workers - 1, work);
      work();
    } catch (...) {
      // Those that are at work stop before their next piece.
      next = count;
      throw;
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace limitgauge::model
