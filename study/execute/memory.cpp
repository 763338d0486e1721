#include "study/execute/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace limitgauge::study {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
/// What cases of one forecast may still differ by.
constexpr double kReserve = 1.1;

std::uint64_t number_in(const fs::path& file, std::uint64_t otherwise) {
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
    const std::uint64_t most = number_in(top / group / files.most, kNoLimit);
    const std::uint64_t taken = number_in(top / group / files.taken, 0);
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

std::uint64_t MemoryBudget::expected(std::uint64_t forecast_bytes) const {
  if (worst_ratio_ == 0) return forecast_bytes;
  return static_cast<std::uint64_t>(kReserve * worst_ratio_ * static_cast<double>(forecast_bytes));
}

void MemoryBudget::learn(std::uint64_t forecast_bytes, std::uint64_t peak_bytes) {
  if (forecast_bytes == 0 || peak_bytes == 0) return;
  worst_ratio_ =
      std::max(worst_ratio_, static_cast<double>(peak_bytes) / static_cast<double>(forecast_bytes));
}

}  // namespace limitgauge::study
