#include "simulator/stock/in_own_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string_view>

#include "model/base/error.h"

namespace limitgauge::simulator {
namespace {

constexpr int kDone = 0, kBroken = 1, kNoRoom = 2;

[[noreturn]] void fail(const std::string& what, int reason) {
  throw model::ResourceError(what + (reason == 0 ? "" : std::string(": ") + std::strerror(reason)));
}

/// Memory with a descriptor, which outlives the process that wrote it. A pipe would have to be
/// emptied meanwhile, and stays open where another thread forks at the wrong moment.
class Answer {
 public:
  Answer() : descriptor_(memfd_create("limitgauge-answer", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail("there is no memory for the answer of a process", errno);
  }
  ~Answer() { close(descriptor_); }
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;

  bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) return false;
      if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  /// None for more than `most_bytes`.
  std::optional<std::string> read(std::size_t most_bytes) const {
    struct stat found {};
    if (fstat(descriptor_, &found) != 0) fail("the answer of a process is lost", errno);
    const auto size = static_cast<std::size_t>(found.st_size);
    if (size > most_bytes) return std::nullopt;
    std::string bytes(size, '\0');
    for (std::size_t at = 0; at < size;) {
      const ssize_t got = pread(descriptor_, bytes.data() + at, size - at, static_cast<off_t>(at));
      if (got == 0 || (got < 0 && errno != EINTR)) fail("the answer of a process is lost", errno);
      if (got > 0) at += static_cast<std::size_t>(got);
    }
    return bytes;
  }

 private:
  int descriptor_;
};

// Address space in use: the first number of this file, in pages.
std::size_t bytes_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// Where a limit of the user's own is lower, that one stays.
void limit(int what, std::size_t soft, std::size_t hard) {
  const rlimit l{soft, hard};
  static_cast<void>(setrlimit(static_cast<__rlimit_resource_t>(what), &l));
}

// What breaks is to say nothing, leave no core, and run no handler of the process that it came
// from.
void be_quiet() {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGALRM, SIGXCPU})
    std::signal(signal, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    if (nowhere >= 0) dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0, 0);
}

// A terminal's Ctrl-C and Ctrl-Z, its closing, and a scheduler's request reach all processes of a
// group: the one that asked decides, and takes this one with it when it ends.
void leave_signals_to(pid_t parent) {
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGTSTP}) std::signal(signal, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kBroken);  // it ended before it could be said
}

// This process has one thread of those that it was copied from. A lock that another one held stays
// locked: an exception takes a grid down with TBB, and that waits then without using any time.
void end_after(unsigned wall_seconds) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  alarm(wall_seconds);
}

// No destructors on the way out: what they would wait for may belong to threads that this process
// has not.
[[noreturn]] void answer_and_leave(const std::function<std::string()>& work,
                                   const ProcessLimits& limits, std::size_t memory_bytes,
                                   const Answer& answer) {
  be_quiet();
  limit(RLIMIT_AS, memory_bytes, memory_bytes);
  // At the soft limit comes a signal that tells it from a process that somebody killed.
  limit(RLIMIT_CPU, limits.cpu_seconds, limits.cpu_seconds + 1);
  end_after(limits.wall_seconds);
  try {
    const std::string bytes = work();
    // Before the string goes: memory that the work has ruined is not to be given back.
    _exit(answer.write(bytes) ? kDone : kNoRoom);
  } catch (...) {
    _exit(kBroken);
  }
}

int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail("a process is lost", errno);
  return status;
}

}  // namespace

std::optional<std::string> answer_of_own_process(const std::function<std::string()>& work,
                                                 const ProcessLimits& limits) {
  const Answer answer;
  const std::size_t memory_bytes = bytes_in_use() + limits.memory_bytes;
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) fail("no process can be started", errno);
  if (child == 0) {
    leave_signals_to(parent);
    answer_and_leave(work, limits, memory_bytes, answer);
  }
  const int status = status_of(child);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
    fail("a process that read a file was killed: is there too little memory?", 0);
  if (!WIFEXITED(status)) return std::nullopt;
  if (WEXITSTATUS(status) == kNoRoom) fail("the answer of a process finds no room", 0);
  return WEXITSTATUS(status) == kDone ? answer.read(limits.answer_bytes) : std::nullopt;
}

}  // namespace limitgauge::simulator
