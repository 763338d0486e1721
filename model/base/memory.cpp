#include "model/base/memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace limitgauge::model {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
constexpr double kShareOfInstalled = 0.75;
constexpr double kShareOfAvailable = 0.9;

std::uint64_t count_of_file(const fs::path& file, std::uint64_t otherwise) {
  std::uint64_t number = 0;
  // "max" is no number: no limit.
  return std::ifstream(file) >> number ? number : otherwise;
}

std::uint64_t machine_bytes(const fs::path& root) {
  std::ifstream in(root / "proc/meminfo");
  std::string name, unit;
  std::uint64_t kib = 0;
  while (in >> name >> kib && std::getline(in, unit))
    if (name == "MemAvailable:") return kib * 1024;
  return kNoLimit;
}

struct LimitFiles {
  const char *most, *taken;
};

/// What is left in a group and in all that it lies in.
std::uint64_t group_bytes(const fs::path& top, fs::path group, const LimitFiles& files) {
  std::uint64_t left = kNoLimit;
  for (;; group = group.parent_path()) {
    const std::uint64_t most = count_of_file(top / group / files.most, kNoLimit);
    const std::uint64_t taken = count_of_file(top / group / files.taken, 0);
    if (most != kNoLimit) left = std::min(left, most - std::min(most, taken));
    if (group.empty()) return left;
  }
}

/// A line of proc/self/cgroup is NUMBER:CONTROLLERS:/GROUP; no controllers: version 2.
std::uint64_t groups_bytes(const fs::path& root) {
  std::uint64_t left = kNoLimit;
  std::ifstream in(root / "proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = fs::path(line.substr(second + 1)).relative_path();
    const fs::path top = root / "sys/fs/cgroup";
    if (controllers.empty())
      left = std::min(left, group_bytes(top, group, {"memory.max", "memory.current"}));
    else if (controllers == "memory")
      left = std::min(left, group_bytes(top / "memory", group,
                                        {"memory.limit_in_bytes", "memory.usage_in_bytes"}));
  }
  return left;
}

}  // namespace

std::uint64_t available_memory_bytes(const fs::path& root) {
  return std::min(machine_bytes(root), groups_bytes(root));
}

std::size_t run_memory_limit_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_bytes = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || page_bytes <= 0) return std::numeric_limits<std::size_t>::max();
  return static_cast<std::size_t>(kShareOfInstalled * static_cast<double>(pages) *
                                  static_cast<double>(page_bytes));
}

std::uint64_t shared_memory_limit_bytes() {
  return static_cast<std::uint64_t>(kShareOfAvailable *
                                    static_cast<double>(available_memory_bytes()));
}

void reset_process_peak() {
  std::ofstream("/proc/self/clear_refs") << "5\n";
}

std::uint64_t process_peak_bytes() {
  std::ifstream in("/proc/self/status");
  for (std::string name; in >> name;) {
    std::uint64_t kib = 0;
    if (name == "VmHWM:" && in >> kib) return kib * 1024;
  }
  return 0;
}

}  // namespace limitgauge::model
