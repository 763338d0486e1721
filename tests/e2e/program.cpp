#include "tests/e2e/program.h"
#include "tests/support/folders.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace limitgauge::e2e {
namespace fs = std::filesystem;
namespace {

/// In the child: nothing here may return.
[[noreturn]] void become_program(const fs::path& folder, const std::vector<std::string>& arguments,
                                 const Conditions& conditions, const fs::path& log) {
  const auto redirect = [&](const char* suffix, int descriptor) {
    const fs::path file = log.string() + suffix;
    dup2(open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), descriptor);
  };
  redirect(".out", STDOUT_FILENO);
  redirect(".err", STDERR_FILENO);
  if (conditions.largest_file_bytes) {
    const rlimit limit{*conditions.largest_file_bytes, *conditions.largest_file_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (chdir(folder.c_str()) != 0) _exit(127);
  std::vector<char*> words = {const_cast<char*>(LIMITGAUGE_PROGRAM)};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(LIMITGAUGE_PROGRAM, words.data());
  _exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("waitpid failed");
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "limitgauge-e2e-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Scratch::entries() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Outcome limitgauge(const Scratch& folder, const std::vector<std::string>& arguments,
                   const Conditions& conditions) {
  const Scratch logs;
  const fs::path log = logs / "log";
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) become_program(folder.path(), arguments, conditions, log);
  if (conditions.interrupt_after) {
    std::this_thread::sleep_for(*conditions.interrupt_after);
    kill(child, SIGINT);
  }
  Outcome outcome;
  outcome.exit_code = wait_for(child);
  outcome.out = read_text(log.string() + ".out");
  outcome.errors = read_text(log.string() + ".err");
  return outcome;
}

std::string read_text(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return std::move(text).str();
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string fixture(const std::string& name) {
  return tests::fixtures().string() + "/" + name;
}

}  // namespace limitgauge::e2e
