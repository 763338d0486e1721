#include "model/base/memory.h"

#include <fstream>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::model {
namespace {

TEST_CASE("memory that is left, of the machine and of control groups", "[unit][memory]") {
  const tests::TemporaryFolder root;
  const auto write = [&](const std::string& file, const std::string& text) {
    std::filesystem::create_directories((root.path() / file).parent_path());
    std::ofstream(root.path() / file) << text;
  };
  CHECK(available_memory_bytes(root.path()) == ~std::uint64_t{0});
  write("proc/meminfo", "MemTotal:  16000 kB\nMemFree:  100 kB\nMemAvailable:  9000 kB\n");
  CHECK(available_memory_bytes(root.path()) == 9000 * 1024);
  write("proc/self/cgroup", "0::/user/job\n");
  write("sys/fs/cgroup/user/job/memory.max", "max\n");
  CHECK(available_memory_bytes(root.path()) == 9000 * 1024);
  write("sys/fs/cgroup/user/memory.max", "5000000\n");
  write("sys/fs/cgroup/user/memory.current", "1000000\n");
  CHECK(available_memory_bytes(root.path()) == 4000000);
  write("proc/self/cgroup", "4:memory:/docker/x\n1:cpu:/\n");
  write("sys/fs/cgroup/memory/docker/x/memory.limit_in_bytes", "3000000\n");
  write("sys/fs/cgroup/memory/docker/x/memory.usage_in_bytes", "2999999\n");
  CHECK(available_memory_bytes(root.path()) == 1);
  CHECK(available_memory_bytes() > 0);
}

}  // namespace
}  // namespace limitgauge::model
