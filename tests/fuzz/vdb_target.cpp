#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "model/mesh/mesh_defect.h"
#include "simulator/grid/vdb_answer.h"
#include "simulator/grid/vdb_stock.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/vdb_mutation.h"
#include "tests/fuzz/vdb_process.h"

using namespace limitgauge;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// The address sanitizer has memory of its own, which vdb_reading.cpp cannot mark: it is to do the
/// same. Asked for by it, and by nobody else.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "malloc_fill_byte=127";
}

namespace {

constexpr std::size_t kPage = 4096, kEdges = 8 * kPage;

/// How often edges of the reader were passed, as libFuzzer reads it beside its own counters.
alignas(kPage) __attribute__((section("__libfuzzer_extra_counters"))) std::uint8_t edges[kEdges];

/// Has edges count that are passed in the process that reads the file.
void share_edges() {
  const void* const shared = mmap(edges, sizeof edges, PROT_READ | PROT_WRITE,
                                  MAP_SHARED | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("mmap");
}

/// That process may break down, which is no finding: libFuzzer is not to keep its input.
void be_silent() {
  __sanitizer_set_death_callback([] {});
}

constexpr std::size_t kMemory = std::size_t{64} << 20;

/// What lives as long as the target does, and what became of the files so far, told at the end.
struct Run {
  Run() {
    share_edges();
    pthread_atfork(nullptr, nullptr, be_silent);
  }
  ~Run() {
    std::fprintf(
        stderr,
        "vdb: %zu files: %zu accepted, %zu refused, %zu of these because the process broke "
        "down; %zu beyond the memory\n",
        accepted + refused + too_large, accepted, refused, broken, too_large);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  fuzz::MemoryFile file;
  fuzz::VdbProcess process{kMemory};
  std::size_t accepted = 0, refused = 0, too_large = 0, broken = 0;
};

/// A message names the file and can be shown.
void require_words(const std::string& words, const std::filesystem::path& path) {
  fuzz::require(words.starts_with(path.string() + ": "), "a message names the file");
  for (const char c : words) fuzz::require(c >= ' ' && c <= '~', "a message can be shown");
}

simulator::VdbStock stock_of(Run& run) {
  // One of so many in a process of its own, as the program has it.
  constexpr std::size_t kAsTheProgram = 16;
  const std::size_t files = run.accepted + run.refused + run.too_large;
  const auto path = run.file.path();
  if (files % kAsTheProgram == 0) return simulator::read_vdb_stock(path, kMemory);
  if (const auto answer = run.process.answer(run.file))
    return simulator::read_vdb_answer(*answer, path);
  throw model::InputError({path.string()}, "OpenVDB breaks down over the file");
}

void read(Run& run) {
  try {
    const simulator::VdbStock stock = stock_of(run);
    fuzz::require(stock.voxel_mm > 0, "voxels have a size");
    fuzz::require(stock.blunt_mm > 0, "edges are blunt");
    fuzz::require(!find_defect(stock.mesh), "a stock that was read bounds a solid");
    ++run.accepted;
  } catch (const model::InputError& error) {
    require_words(error.what(), run.file.path());
    ++run.refused;
    if (std::strstr(error.what(), "breaks down") == nullptr) return;
    ++run.broken;
    // Such a file is no ground to grow others on: they would all take as long.
    std::ranges::fill(edges, std::uint8_t{0});
  } catch (const model::ResourceError& error) {
    require_words(error.what(), run.file.path());
    ++run.too_large;
  }
}

}  // namespace

/// What the compiler and the linker have the reader call at every edge.
extern "C" __attribute__((no_sanitize("all"))) void __wrap___sanitizer_cov_trace_pc() {
  const auto place = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
  ++edges[(place ^ place >> 15) % kEdges];
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Run run;
  run.file.write({data, size});
  read(run);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  // Half of the changes are libFuzzer's own: bits, bytes, words of the dictionary, splices.
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  return fuzz::damage_vdb({data, most}, size, seed);
}
