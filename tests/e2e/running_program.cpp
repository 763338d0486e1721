#include "tests/e2e/running_program.h"

#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace limitgauge::e2e {

namespace fs = std::filesystem;

RunningProgram::RunningProgram(const Scratch& folder, const std::vector<std::string>& arguments,
                               const std::function<void()>& in_child) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), LIMITGAUGE_PROGRAM);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  child_ = fork();
  if (child_ < 0) throw std::runtime_error("fork failed");
  if (child_ == 0) {
    // Tests that were started in the background ignore it, and a program keeps what it was given.
    ::signal(SIGINT, SIG_DFL);
    ::signal(SIGTERM, SIG_DFL);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    if (in_child) in_child();
    if (chdir(folder.path().c_str()) == 0) execv(LIMITGAUGE_PROGRAM, pointers.data());
    _exit(127);
  }
  close(ends[1]);
  out_ = ends[0];
}

RunningProgram::~RunningProgram() {
  if (child_ > 0) end(SIGKILL);
  close(out_);
}

std::string RunningProgram::line() {
  std::string text;
  for (char c = 0; ::read(out_, &c, 1) == 1 && c != '\n';) text += c;
  return text;
}

bool RunningProgram::opens(const fs::path& file) const {
  const fs::path process = "/proc/" + std::to_string(child_), target = fs::canonical(file);
  for (int i = 0; i < 3000; ++i) {
    std::error_code gone;
    // Before it is the program it has what this process has open.
    if (is_program(process))
      for (fs::directory_iterator entry(process / "fd", gone), end; entry != end;
           entry.increment(gone))
        if (fs::read_symlink(entry->path(), gone) == target) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

int RunningProgram::end(int signal) {
  kill(child_, signal);
  int status = 0;
  if (waitpid(child_, &status, 0) != child_) throw std::runtime_error("waitpid failed");
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::string answer_of(int port, const std::string& request) {
  const int client = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string text;
  if (connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      send(client, request.data(), request.size(), MSG_NOSIGNAL) > 0) {
    char part[65536];
    for (ssize_t got = 0; (got = recv(client, part, sizeof part, 0)) > 0;)
      text.append(part, static_cast<std::size_t>(got));
  }
  close(client);
  return text;
}

}  // namespace limitgauge::e2e
