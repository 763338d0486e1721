#include "study/execute/worker_process.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include "model/base/error.h"
#include "study/execute/spawn.h"

namespace limitgauge::study {
namespace {

constexpr std::chrono::milliseconds kLook{5};
/// An idle worker only has its memory to give back.
constexpr std::chrono::milliseconds kToLeave{5000};

std::string description(int status) {
  if (WIFEXITED(status)) return "ended with exit code " + std::to_string(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  std::string words =
      "was killed by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  // Who kills a process for the memory it takes sends this one.
  return signal == SIGKILL ? words + "; out of memory?" : words;
}

}  // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string>& command) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw model::ResourceError(std::string("cannot talk to a worker process: ") +
                               std::strerror(errno));
  }
  socket_ = ends[0];
  const Spawned spawned = spawn(command, {{ends[1], STDIN_FILENO}, {ends[1], STDOUT_FILENO}});
  ::close(ends[1]);
  process_ = spawned.process;
  if (spawned.error == 0) return;
  ::close(socket_);
  throw model::ResourceError("cannot start a worker process (" + command.front() +
                             "): " + std::strerror(spawned.error));
}

WorkerProcess::~WorkerProcess() {
  ::shutdown(socket_, SHUT_RDWR);
  end(kToLeave);
  ::close(socket_);
}

void WorkerProcess::send(const std::string& line) {
  std::size_t sent = 0;
  while (sent < line.size()) {
    const ssize_t count = ::send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

std::vector<std::string> WorkerProcess::lines() {
  char bytes[4096];
  for (;;) {
    const ssize_t count = ::recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK)) ended_ = true;
    if (count <= 0) break;
    unread_.append(bytes, static_cast<std::size_t>(count));
  }
  std::vector<std::string> found;
  std::size_t begin = 0;
  for (std::size_t end = unread_.find('\n'); end != std::string::npos;
       end = unread_.find('\n', begin)) {
    found.push_back(unread_.substr(begin, end - begin));
    begin = end + 1;
  }
  unread_.erase(0, begin);
  return found;
}

void WorkerProcess::interrupt() {
  if (!status_) ::kill(process_, SIGTERM);
}

bool WorkerProcess::reaped_within(std::chrono::milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    int status = 0;
    const pid_t found = ::waitpid(process_, &status, WNOHANG);
    if (found == process_) status_ = status;
    if (found != 0 && !(found < 0 && errno == EINTR)) return true;
    if (std::chrono::steady_clock::now() >= until) return false;
    std::this_thread::sleep_for(kLook);
  }
}

std::string WorkerProcess::end(std::chrono::milliseconds patience) {
  if (!status_ && !reaped_within(patience)) {
    ::kill(process_, SIGKILL);
    reaped_within(std::chrono::hours(1));
  }
  return status_ ? description(*status_) : "ended";
}

}  // namespace limitgauge::study
