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

/// In the child, as all down to become_program().
void redirect(const fs::path& file, int descriptor) {
  dup2(open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), descriptor);
}

void set_out(Conditions::Out kind, const fs::path& file) {
  int ends[2];
  switch (kind) {
    case Conditions::Out::file:
      redirect(file, STDOUT_FILENO);
      return;
    case Conditions::Out::full:
      redirect("/dev/full", STDOUT_FILENO);
      return;
    case Conditions::Out::pipe_nobody_reads:
      if (pipe(ends) != 0) _exit(127);
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
      return;
    case Conditions::Out::closed:
      return;  // last of all: what is opened next would take its number
  }
}

void limit(__rlimit_resource what, const std::optional<std::size_t>& most) {
  const rlimit both{most.value_or(0), most.value_or(0)};
  if (most) setrlimit(what, &both);
}

void set_limits(const Conditions& conditions) {
  constexpr uid_t kNobody = 65534;
  limit(RLIMIT_FSIZE, conditions.largest_file_bytes);
  limit(RLIMIT_NOFILE, conditions.most_descriptors);
  limit(RLIMIT_AS, conditions.most_memory_bytes);
  limit(RLIMIT_NPROC, conditions.most_threads);
  if (conditions.most_threads && geteuid() == 0 && setuid(kNobody) != 0) _exit(127);
}

/// Nothing here may return. The program is opened before it is to be anybody else's.
[[noreturn]] void become_program(const fs::path& folder, const std::vector<std::string>& arguments,
                                 const Conditions& conditions, const fs::path& log) {
  const int program = open(LIMITGAUGE_PROGRAM, O_RDONLY | O_CLOEXEC);
  set_out(conditions.out, log.string() + ".out");
  redirect(log.string() + ".err", STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(127);
  set_limits(conditions);
  std::vector<char*> words = {const_cast<char*>(LIMITGAUGE_PROGRAM)};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  if (conditions.out == Conditions::Out::closed) close(STDOUT_FILENO);
  fexecve(program, words.data(), environ);
  _exit(127);
}

bool catches(const fs::path& process, int signal) {
  std::ifstream status(process / "status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("SigCgt:", 0) == 0)
      return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
  return false;
}

/// Waits until the process is the program and catches interrupts, for half a minute at most: a
/// signal before that ends it as it would any.
void wait_until_it_catches(pid_t child) {
  const fs::path process = "/proc/" + std::to_string(child);
  for (int i = 0; i < 3000; ++i) {
    if (is_program(process) && catches(process, SIGINT)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

void wait_for(pid_t child, Outcome& outcome) {
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child) throw std::runtime_error("wait4 failed");
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.peak_bytes = 1024.0 * static_cast<double>(used.ru_maxrss);
}

}  // namespace

bool is_program(const fs::path& process) {
  std::error_code gone;
  return fs::read_symlink(process / "exe", gone) == fs::canonical(LIMITGAUGE_PROGRAM);
}

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
    wait_until_it_catches(child);
    std::this_thread::sleep_for(*conditions.interrupt_after);
    kill(child, SIGINT);
  }
  Outcome outcome;
  wait_for(child, outcome);
  outcome.out = read_text(log.string() + ".out");
  outcome.errors = read_text(log.string() + ".err");
  return outcome;
}

std::vector<std::string> coarsely(std::vector<std::string> command,
                                  const std::vector<std::string>& more) {
  for (const char* setting :
       {"stage.rough.step=1", "stage.rough.gate.uncut=2", "stage.finish.gate.uncut=0.2",
        "simulation.voxel=0.5", "verification.resolution=0.02"})
    command.insert(command.end(), {"--set", setting});
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::vector<std::string> run_coarse_job(const std::string& output,
                                        const std::vector<std::string>& more) {
  return coarsely({"run", fixture("jobs/quick-dome.toml"), "-o", output, "--no-pictures"}, more);
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
