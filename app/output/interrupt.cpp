#include "app/output/interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <string_view>

namespace limitgauge::app {
namespace {

constexpr int kExitCode = 4;

// A signal handler can reach nothing but a global; it is written there and nowhere else.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_patience_lost(int) {
  constexpr std::string_view kWords = "limitgauge: interrupted; nothing was kept\n";
  static_cast<void>(!::write(STDERR_FILENO, kWords.data(), kWords.size()));
  ::_exit(kExitCode);
}

extern "C" void on_interrupt(int signal) {
  interrupted.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
  const itimerval patience{{0, 0}, {kMostToStop_ms / 1000, kMostToStop_ms % 1000 * 1000}};
  ::setitimer(ITIMER_REAL, &patience, nullptr);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // What was started with a signal ignored (nohup) keeps ignoring it.
    if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGALRM, on_patience_lost);
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
  return interrupted;
}

}  // namespace limitgauge::app
