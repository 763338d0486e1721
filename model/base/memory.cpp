#include "model/base/memory.h"

#include <malloc.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace limitgauge::model {
namespace fs = std::filesystem;
namespace {

constexpr const char* kAddressLimit = "Max address space ";
constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
constexpr double kMiB = 1024.0 * 1024.0;

/// Of what is available. Forecasts are as a rule a tenth too high, and at most half too low
/// (tests/e2e/memory/memory_test.cpp): a run forecast to take all of its limit then takes six
/// fifths of what was there, and one that is a quarter too low just fits.
constexpr double kShareOfAvailable = 0.8;

/// Of address space, that threads reserve and hardly use: the stacks of ten, 8 MiB each. Heaps of
/// their own they have none there, see spare_addresses().
constexpr std::uint64_t kThreadAddresses = std::uint64_t{80} << 20;

std::uint64_t left_of(std::uint64_t most, std::uint64_t taken) {
  return most == kNoLimit ? kNoLimit : most - std::min(most, taken);
}

/// The number after `name` at the beginning of a line; files of the kernel are NAME NUMBER ….
std::optional<std::uint64_t> number_after(const fs::path& file, std::string_view name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::uint64_t number = 0;
    if (line.starts_with(name) && std::istringstream(line.substr(name.size())) >> number)
      return number;
  }
  return std::nullopt;
}

std::uint64_t kib_after(const fs::path& file, std::string_view name, std::uint64_t otherwise) {
  const std::optional<std::uint64_t> kib = number_after(file, name);
  return kib ? *kib * 1024 : otherwise;
}

/// "max" is no number: no limit.
std::uint64_t count_of_file(const fs::path& file, std::uint64_t otherwise) {
  return number_after(file, "").value_or(otherwise);
}

struct GroupFiles {
  const char *most, *taken;
  const char* droppable;  ///< in memory.stat: pages of files that nobody has used lately
};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file "};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file "};

/// What is left in a group and in all that it lies in.
std::uint64_t group_bytes(const fs::path& top, fs::path group, const GroupFiles& files) {
  std::uint64_t left = kNoLimit;
  for (;; group = group.parent_path()) {
    const fs::path folder = top / group;
    const std::uint64_t most = count_of_file(folder / files.most, kNoLimit);
    const std::uint64_t taken = count_of_file(folder / files.taken, 0);
    const std::uint64_t droppable =
        number_after(folder / "memory.stat", files.droppable).value_or(0);
    left = std::min(left, left_of(most, taken - std::min(taken, droppable)));
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
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const fs::path group = fs::path(line.substr(second + 1)).relative_path();
    const fs::path top = root / "sys/fs/cgroup";
    if (controllers == ",,")
      left = std::min(left, group_bytes(top, group, kVersion2));
    else if (controllers.find(",memory,") != std::string::npos)
      left = std::min(left, group_bytes(top / "memory", group, kVersion1));
  }
  return left;
}

/// What `ulimit -v`, less what threads reserve, and `ulimit -d` leave.
std::uint64_t process_bytes(const fs::path& root) {
  const fs::path limits = root / "proc/self/limits", status = root / "proc/self/status";
  const auto left = [&](const char* most, const char* taken, std::uint64_t reserved) {
    return left_of(number_after(limits, most).value_or(kNoLimit),
                   kib_after(status, taken, 0) + reserved);
  };
  return std::min(left(kAddressLimit, "VmSize:", kThreadAddresses),
                  left("Max data size ", "VmData:", 0));
}

}  // namespace

std::uint64_t available_memory_bytes(const fs::path& root) {
  const std::uint64_t machine = kib_after(root / "proc/meminfo", "MemAvailable:", kNoLimit);
  return std::min({machine, groups_bytes(root), process_bytes(root)});
}

std::uint64_t memory_limit_bytes(const fs::path& root) {
  const std::uint64_t available = available_memory_bytes(root);
  if (available == kNoLimit) return kNoLimit;
  return static_cast<std::uint64_t>(kShareOfAvailable * static_cast<double>(available));
}

std::string in_mib(double bytes) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f MiB", bytes < 10 * kMiB ? 1 : 0, bytes / kMiB);
  return text;
}

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void spare_addresses() {
#ifdef __GLIBC__
  if (number_after("/proc/self/limits", kAddressLimit)) mallopt(M_ARENA_MAX, 1);
#endif
}

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  const auto from = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t low = (from + kPage - 1) / kPage * kPage,
                       high = (from + bytes) / kPage * kPage;
  if (low < high) madvise(reinterpret_cast<void*>(low), high - low, MADV_HUGEPAGE);
#endif
}

void reset_process_peak() {
  std::ofstream("/proc/self/clear_refs") << "5\n";
}

std::uint64_t process_peak_bytes() {
  return kib_after("/proc/self/status", "VmHWM:", 0);
}

}  // namespace limitgauge::model
