#include "tests/fuzz/vdb_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>

#include "simulator/grid/grid_file.h"
#include "simulator/grid/vdb_reading.h"
#include "tests/fuzz/reading.h"

namespace limitgauge::fuzz {
namespace {

constexpr int kMostAnswers = 500;  // OpenVDB loses memory where a file breaks off
constexpr rlim_t kMemory = rlim_t{1} << 27;

/// One that breaks down is to say nothing and run none of libFuzzer's handlers.
void be_quiet() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGALRM, SIGPROF})
    std::signal(signal, SIG_DFL);
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
}

void limit_memory() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + kMemory;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

/// For the next file: so much processor time, of which a small sound one takes a twentieth, and
/// some of the clock's.
void limit_time() {
  constexpr suseconds_t kLongest_us = 100'000;
  constexpr unsigned kLongestWait_s = 10;
  const itimerval limit{{0, 0}, {0, kLongest_us}};
  setitimer(ITIMER_PROF, &limit, nullptr);
  alarm(kLongestWait_s);
}

/// One byte; false where the other end is gone.
bool get(int end) {
  char byte = 0;
  ssize_t got = 0;
  while ((got = ::recv(end, &byte, 1, 0)) < 0 && errno == EINTR) {
  }
  return got == 1;
}

bool put(int end) {
  return ::send(end, "", 1, MSG_NOSIGNAL) == 1;
}

}  // namespace

MemoryFile::MemoryFile() : descriptor_(memfd_create("vdb", 0)) {
  require(descriptor_ >= 0, "there is memory for a file");
}

MemoryFile::~MemoryFile() {
  ::close(descriptor_);
}

void MemoryFile::write(std::span<const std::uint8_t> bytes) const {
  require(::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, bytes.data(), bytes.size(),
                                                       0) == static_cast<ssize_t>(bytes.size()),
          "a file is written");
}

std::string MemoryFile::read() const {
  std::ostringstream text;
  text << std::ifstream(path(), std::ios::binary).rdbuf();
  return std::move(text).str();
}

std::filesystem::path MemoryFile::path() const {
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

std::optional<std::string> VdbProcess::answer(const MemoryFile& file) {
  if (answered_ == kMostAnswers) end();
  if (process_ < 0) start(file);
  ++answered_;
  if (put(requests_) && get(requests_)) return answer_.read();
  end();
  return std::nullopt;
}

void VdbProcess::start(const MemoryFile& file) {
  int ends[2] = {-1, -1};
  require(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0, "a socket");
  simulator::vdb::start_openvdb();
  process_ = ::fork();
  require(process_ >= 0, "a process");
  if (process_ == 0) {
    ::close(ends[0]);
    serve(file, ends[1]);
  }
  ::close(ends[1]);
  requests_ = ends[0];
  answered_ = 0;
}

void VdbProcess::end() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  ::close(requests_);
  process_ = -1;
}

void VdbProcess::serve(const MemoryFile& file, int requests) const {
  be_quiet();
  limit_memory();
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (bool asked = get(requests); asked; asked = put(requests) && get(requests)) {
    limit_time();
    std::optional<simulator::VdbReading> kept;
    const std::string answer = simulator::vdb_answer_about(file.path(), memory_limit_bytes_, kept);
    answer_.write({reinterpret_cast<const std::uint8_t*>(answer.data()), answer.size()});
  }
  ::_exit(0);
}

}  // namespace limitgauge::fuzz
