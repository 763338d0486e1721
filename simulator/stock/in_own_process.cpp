#include "simulator/stock/in_own_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>

#include "model/base/error.h"

namespace limitgauge::simulator {
namespace {

// Address space in use: the first number of this file, in pages.
std::size_t bytes_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limit(int what, std::size_t most) {
  const rlimit l{most, most};
  static_cast<void>(setrlimit(static_cast<__rlimit_resource_t>(what), &l));
}

// What breaks is to say nothing, leave no core, and run no handler of the process that it came
// from.
void be_quiet() {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGALRM})
    std::signal(signal, SIG_DFL);
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  limit(RLIMIT_CORE, 0);
}

// This process has one thread of those that it was copied from. A lock that another one held stays
// locked: an exception takes a grid down with TBB, and that waits then without using any time.
void end_after(unsigned wall_seconds) {
  sigset_t alarm_only;
  sigemptyset(&alarm_only);
  sigaddset(&alarm_only, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &alarm_only, nullptr);
  alarm(wall_seconds);
}

[[noreturn]] void work_and_leave(const std::function<void()>& work, const ProcessLimits& limits,
                                 std::size_t bytes_before) {
  constexpr int kDone = 0, kBroken = 1;
  be_quiet();
  limit(RLIMIT_AS, bytes_before + limits.memory_bytes);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  end_after(limits.wall_seconds);
  try {
    work();
  } catch (const std::bad_alloc&) {
    _exit(kBroken);
  } catch (const std::exception&) {
    _exit(kDone);
  }
  // No destructors: what they would wait for may belong to threads that this process has not.
  _exit(kDone);
}

}  // namespace

bool comes_to_its_end(const std::function<void()>& work, const ProcessLimits& limits) {
  const std::size_t bytes_before = bytes_in_use();
  const pid_t child = fork();
  if (child < 0)
    throw model::ResourceError(std::string("no process can be started: ") + std::strerror(errno));
  if (child == 0) work_and_leave(work, limits, bytes_before);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw model::ResourceError(std::string("a process is lost: ") + std::strerror(errno));
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace limitgauge::simulator
