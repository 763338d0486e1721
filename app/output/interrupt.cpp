#include "app/output/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace limitgauge::app {
namespace {

// A signal handler can reach nothing but a global; it is written there and nowhere else.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int signal) {
  interrupted.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // What was started with a signal ignored (nohup) keeps ignoring it.
    if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGXFSZ, SIG_IGN);
  return interrupted;
}

}  // namespace limitgauge::app
