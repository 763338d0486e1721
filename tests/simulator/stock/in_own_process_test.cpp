#include "simulator/stock/in_own_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <stdexcept>

#include "model/base/error.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::simulator;

namespace {

constexpr ProcessLimits kLimits{std::size_t{1} << 28, 5, 60, 1 << 20};

std::optional<std::string> answer_of(const std::function<std::string()>& work) {
  return answer_of_own_process(work, kLimits);
}

/// A process of its own that waits for one; the number of that one comes through `pipe`.
pid_t start_waiting_parent(const int (&pipe)[2]) {
  const pid_t parent = fork();
  if (parent != 0) return parent;
  static_cast<void>(answer_of([&] {
    const pid_t self = getpid();
    if (::write(pipe[1], &self, sizeof self) == sizeof self) pause();
    return std::string();
  }));
  _exit(0);
}

}  // namespace

TEST_CASE("the answer of a process comes back byte by byte", "[unit][vdb]") {
  CHECK(answer_of([] { return std::string(); }) == "");
  const std::string bytes("a\0b\xff", 4);
  CHECK(answer_of([&] { return bytes; }) == bytes);
  const std::string long_one(kLimits.answer_bytes, 'x');
  CHECK(answer_of([&] { return long_one; }) == long_one);
  CHECK_FALSE(answer_of([&] { return long_one + "x"; }));
}

TEST_CASE("work that breaks down does so in its own process", "[unit][vdb]") {
  CHECK_FALSE(answer_of([]() -> std::string { throw std::runtime_error("an exception"); }));
  CHECK_FALSE(answer_of([]() -> std::string { throw std::bad_alloc(); }));
  CHECK_FALSE(answer_of([]() -> std::string { throw 1; }));
  CHECK_FALSE(answer_of([]() -> std::string { std::abort(); }));
  CHECK_FALSE(answer_of([] { return std::string(2 * kLimits.memory_bytes, 'x'); }));
}

TEST_CASE("work that waits or computes for ever is ended", "[unit][vdb]") {
  const auto wait = [] { return pause(), std::string(); };
  CHECK_FALSE(answer_of_own_process(wait, {std::size_t{1} << 28, 5, 1, 0}));
  const auto compute = [] {
    for (volatile int forever = 1; forever != 0;) {
    }
    return std::string();
  };
  CHECK_FALSE(answer_of_own_process(compute, {std::size_t{1} << 28, 1, 60, 0}));
}

TEST_CASE("what a terminal says to all processes is left to the one that asked", "[unit][vdb]") {
  const int signal = GENERATE(SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGTSTP);
  CHECK(answer_of([&] { return raise(signal), std::string("done"); }) == "done");
}

TEST_CASE("a process that somebody killed says nothing of its file", "[unit][vdb]") {
  CHECK_THROWS_AS(answer_of([] { return raise(SIGKILL), std::string(); }), model::ResourceError);
}

TEST_CASE("a process ends with the one that waits for it", "[unit][vdb]") {
  // Whose parent ends comes to us.
  REQUIRE(prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
  int pipe[2];
  REQUIRE(::pipe(pipe) == 0);
  const pid_t parent = start_waiting_parent(pipe);
  pid_t child = 0;
  REQUIRE(::read(pipe[0], &child, sizeof child) == sizeof child);
  kill(parent, SIGKILL);
  REQUIRE(waitpid(parent, nullptr, 0) == parent);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK((WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL));
  for (const int end : pipe) close(end);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}
