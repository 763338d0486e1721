#include "study/execute/spawn.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "model/base/error.h"

namespace limitgauge::study {
namespace {

struct Attributes {
  explicit Attributes(bool apart) {
    posix_spawnattr_init(&value);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&value, &none);
    posix_spawnattr_setpgroup(&value, 0);
    // What we ignore to hear of it as an error, other programs expect to end them.
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&ending, signal);
    posix_spawnattr_setsigdefault(&value, &ending);
    posix_spawnattr_setflags(&value,
                             static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                                (apart ? POSIX_SPAWN_SETPGROUP : 0)));
  }
  ~Attributes() { posix_spawnattr_destroy(&value); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  posix_spawnattr_t value;
};

struct Actions {
  explicit Actions(const std::vector<std::pair<int, int>>& descriptors) {
    posix_spawn_file_actions_init(&value);
    for (const auto& [ours, its] : descriptors) posix_spawn_file_actions_adddup2(&value, ours, its);
  }
  ~Actions() { posix_spawn_file_actions_destroy(&value); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  posix_spawn_file_actions_t value;
};

/// How often it is looked whether a program is to be waited for any longer.
constexpr int kLookAtStop_ms = 50;

class Patience {
 public:
  explicit Patience(const ProgramPatience& of)
      : of_(of), end_(std::chrono::steady_clock::now() + of.longest) {}
  bool is_over() const {
    return (of_.stop != nullptr && *of_.stop) || std::chrono::steady_clock::now() >= end_;
  }

 private:
  const ProgramPatience& of_;
  std::chrono::steady_clock::time_point end_;
};

/// Both at once: a program that fills one of them while we wait at the other would never end. False
/// where that takes longer than there is patience.
bool read_both(std::array<int, 2> from, std::array<std::string*, 2> into,
               const Patience& patience) {
  std::array<pollfd, 2> waiting = {pollfd{from[0], POLLIN, 0}, pollfd{from[1], POLLIN, 0}};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    if (patience.is_over()) return false;
    if (::poll(waiting.data(), waiting.size(), kLookAtStop_ms) < 0) {
      if (errno != EINTR) return true;
      continue;
    }
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].fd < 0 || waiting[i].revents == 0) continue;
      char bytes[4096];
      const ssize_t count = ::read(waiting[i].fd, bytes, sizeof bytes);
      if (count > 0) into[i]->append(bytes, static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) waiting[i].fd = -1;
    }
  }
  return true;
}

struct Pipe {
  Pipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0)
      throw model::ResourceError(std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  ~Pipe() {
    ::close(ends[0]);
    if (ends[1] >= 0) ::close(ends[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_writing() {
    ::close(ends[1]);
    ends[1] = -1;
  }
  int ends[2];
};

int exit_code_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

Spawned spawn(const std::vector<std::string>& command,
              const std::vector<std::pair<int, int>>& descriptors, bool apart) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const Attributes attributes(apart);
  const Actions actions(descriptors);
  Spawned spawned;
  spawned.error = ::posix_spawnp(&spawned.process, words.front(), &actions.value, &attributes.value,
                                 words.data(), environ);
  return spawned;
}

Printed run_program(const std::vector<std::string>& command, const ProgramPatience& patience) {
  Pipe out, errors;
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const Spawned spawned = spawn(
      command,
      {{nothing, STDIN_FILENO}, {out.ends[1], STDOUT_FILENO}, {errors.ends[1], STDERR_FILENO}},
      true);
  ::close(nothing);
  if (spawned.error != 0)
    throw model::ResourceError("cannot start " + command.front() + ": " +
                               std::strerror(spawned.error));
  out.close_writing();
  errors.close_writing();
  Printed printed;
  if (!read_both({out.ends[0], errors.ends[0]}, {&printed.out, &printed.errors},
                 Patience(patience))) {
    printed.errors += command.front() + " did not come to its end in time\n";
    if (patience.goes_on) return printed;
    ::kill(-spawned.process, SIGKILL);
  }
  printed.exit_code = exit_code_of(spawned.process);
  return printed;
}

}  // namespace limitgauge::study
