#include "model/base/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "model/base/error.h"
#include "model/base/run_control.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::model {
namespace {

/// Files of a kernel that is asked instead of the machine's.
class Kernel {
 public:
  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_.path() / file).parent_path());
    std::ofstream(root_.path() / file) << text;
  }
  std::uint64_t available() const { return available_memory_bytes(root_.path()); }
  std::uint64_t limit() const { return memory_limit_bytes(root_.path()); }

 private:
  tests::TemporaryFolder root_;
};

constexpr std::uint64_t kNone = ~std::uint64_t{0};

TEST_CASE("memory that is left, of the machine and of control groups", "[unit][memory]") {
  const Kernel kernel;
  CHECK(kernel.available() == kNone);
  kernel.write("proc/meminfo", "MemTotal:  16000 kB\nMemFree:  100 kB\nMemAvailable:  9000 kB\n");
  CHECK(kernel.available() == 9000 * 1024);
  kernel.write("proc/self/cgroup", "0::/user/job\n");
  kernel.write("sys/fs/cgroup/user/job/memory.max", "max\n");
  CHECK(kernel.available() == 9000 * 1024);
  kernel.write("sys/fs/cgroup/user/memory.max", "5000000\n");
  kernel.write("sys/fs/cgroup/user/memory.current", "1000000\n");
  CHECK(kernel.available() == 4000000);
  kernel.write("proc/self/cgroup", "4:memory:/docker/x\n1:cpu:/\n");
  kernel.write("sys/fs/cgroup/memory/docker/x/memory.limit_in_bytes", "3000000\n");
  kernel.write("sys/fs/cgroup/memory/docker/x/memory.usage_in_bytes", "2999999\n");
  CHECK(kernel.available() == 1);
  kernel.write("proc/self/cgroup", "4:cpu,memory:/docker/x\n");
  CHECK(kernel.available() == 1);
  CHECK(available_memory_bytes() > 0);
}

TEST_CASE("pages of files that the kernel can drop are not taken", "[unit][memory]") {
  const Kernel kernel;
  kernel.write("proc/self/cgroup", "0::/job\n");
  kernel.write("sys/fs/cgroup/job/memory.max", "5000000\n");
  kernel.write("sys/fs/cgroup/job/memory.current", "4500000\n");
  CHECK(kernel.available() == 500000);
  kernel.write("sys/fs/cgroup/job/memory.stat", "anon 100\ninactive_file 3000000\n");
  CHECK(kernel.available() == 3500000);
  kernel.write("proc/self/cgroup", "3:memory:/job\n");
  kernel.write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "5000000\n");
  kernel.write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "4500000\n");
  kernel.write("sys/fs/cgroup/memory/job/memory.stat",
               "inactive_file 1\ntotal_inactive_file 1000000\n");
  CHECK(kernel.available() == 1500000);
}

TEST_CASE("limits of the process leave what it has not taken of them", "[unit][memory]") {
  const Kernel kernel;
  const std::string head = "Limit                     Soft Limit           Hard Limit    Units\n";
  kernel.write("proc/meminfo", "MemAvailable:  9000 kB\n");
  kernel.write("proc/self/status", "Name: x\nVmSize:\t    2000 kB\nVmData:\t    500 kB\n");
  kernel.write("proc/self/limits",
               head +
                   "Max data size             unlimited     unlimited  bytes\n"
                   "Max address space         unlimited     unlimited  bytes\n");
  CHECK(kernel.available() == 9000 * 1024);
  kernel.write("proc/self/limits",
               head +
                   "Max data size             unlimited     unlimited  bytes\n"
                   "Max address space         89006080      unlimited  bytes\n");
  // 80 MiB of 86,920 kB are left to the stacks of threads.
  CHECK(kernel.available() == 3000 * 1024);
  kernel.write("proc/self/limits",
               head +
                   "Max data size             1024000       unlimited  bytes\n"
                   "Max address space         89006080      unlimited  bytes\n");
  CHECK(kernel.available() == 500 * 1024);
  kernel.write("proc/self/status", "VmSize: 9000 kB\nVmData: 9000 kB\n");
  CHECK(kernel.available() == 0);
}

TEST_CASE("a run may take four fifths of what is available", "[unit][memory]") {
  const Kernel kernel;
  CHECK(kernel.limit() == kNone);
  kernel.write("proc/meminfo", "MemAvailable:  1000 kB\n");
  CHECK(kernel.limit() == 800 * 1024);
  kernel.write("proc/self/cgroup", "0::/job\n");
  kernel.write("sys/fs/cgroup/job/memory.max", "500000\n");
  CHECK(kernel.limit() == 400000);
}

// The address sanitizer ends the program itself where a thread's memory cannot be had.
#ifndef __SANITIZE_ADDRESS__
std::size_t address_space_bytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST_CASE("threads that cannot be started end the work with the reason", "[unit][memory]") {
  // Room for eight stacks of 8 MiB: the ninth thread ended the program.
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit few = before;
  few.rlim_cur = address_space_bytes() + (std::size_t{64} << 20);
  setrlimit(RLIMIT_AS, &few);
  std::string said;
  try {
    parallel_for(1000, 1000, [](std::size_t) {});
  } catch (const ResourceError& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_AS, &before);
  CHECK_THAT(said, ContainsSubstring("no thread can be started: "));
}
#endif

}  // namespace
}  // namespace limitgauge::model
