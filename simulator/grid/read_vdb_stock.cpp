#include "simulator/grid/vdb_stock.h"

#include <array>
#include <fstream>
#include <new>
#include <optional>
#include <string>

#include "model/base/error.h"
#include "model/base/text_file.h"
#include "simulator/grid/grid_file.h"
#include "simulator/grid/vdb_answer.h"
#include "simulator/grid/vdb_reading.h"
#include "simulator/stock/in_own_process.h"

namespace limitgauge::simulator {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& wrong,
                       const std::string& expected) {
  throw model::InputError({path.string()}, wrong, expected);
}

// OpenVDB's own messages for these are about its internals.
void require_vdb(const std::filesystem::path& path) {
  model::require_file(path);
  constexpr std::array<char, 4> kMagic = {' ', 'B', 'D', 'V'};
  std::array<char, 4> begin{};
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), begin.size());
  if (!in || begin != kMagic) fail(path, "the file is no .vdb", "a stock.vdb of an earlier run");
}

// Some files have OpenVDB count for ever or fill any amount of memory: fuzz tests are to see many.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
constexpr unsigned kLeastCpuSeconds = 1;
constexpr std::size_t kLeastBytes = std::size_t{1} << 27;
#else
constexpr unsigned kLeastCpuSeconds = 10;
constexpr std::size_t kLeastBytes = std::size_t{1} << 30;
#endif

ProcessLimits limits_for(const std::filesystem::path& path, std::size_t memory_limit_bytes) {
  // A leaf of 2.3 kB takes 64 bytes in the file at least.
  constexpr std::size_t kUnpacked = 64;
  // Reading and meshing takes some 0.4 s of a megabyte.
  constexpr std::size_t kBytesPerSecond = 500'000;
  // A sound file waits for nothing but its turn on a busy machine and for the disk.
  constexpr unsigned kWallPerCpu = 6;
  constexpr std::size_t kLongestWords = 1 << 20;
  std::error_code gone;
  const std::uintmax_t size = std::filesystem::file_size(path, gone);
  if (gone) fail(path, "the file cannot be read: " + gone.message(), {});
  const auto cpu_seconds = static_cast<unsigned>(kLeastCpuSeconds + size / kBytesPerSecond);
  return {kLeastBytes + kUnpacked * size + memory_limit_bytes, cpu_seconds,
          kWallPerCpu * cpu_seconds, memory_limit_bytes + kLongestWords};
}

VdbStock read(const std::filesystem::path& path, std::size_t memory_limit_bytes) {
  vdb::start_openvdb();
  std::optional<VdbReading> kept;
  const auto answer =
      answer_of_own_process([&] { return vdb_answer_about(path, memory_limit_bytes, kept); },
                            limits_for(path, memory_limit_bytes));
  if (!answer)
    fail(path, "OpenVDB breaks down over the file: it is damaged", "a stock.vdb of an earlier run");
  return read_vdb_answer(*answer, path);
}

}  // namespace

VdbStock read_vdb_stock(const std::filesystem::path& path, std::size_t memory_limit_bytes) {
  require_vdb(path);
  try {
    return read(path, memory_limit_bytes);
  } catch (const std::bad_alloc&) {
    throw model::ResourceError(path.string() + ": error: " + kShortOfMemory);
  }
}

}  // namespace limitgauge::simulator
