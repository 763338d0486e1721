#include <benchmark/benchmark.h>

#include "simulator/collision.h"
#include "simulator/stock_model.h"
#include "tests/benchmark/dome_finish.h"

namespace limitgauge::benchmarks {
namespace {

constexpr std::size_t kMemory_bytes = std::size_t{8} << 30;

/// Cutting the shared finish stage; the argument is the voxel in micrometres.
void cut_finish(benchmark::State& state) {
  const simulator::StockModel raw(kBlock, static_cast<double>(state.range(0)) / 1000,
                                  kMemory_bytes);
  const simulator::Pass pass{ball(), dome_finish()};
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(pass, {2, nullptr, {}}));
}
BENCHMARK(cut_finish)->Arg(250)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

void find_collisions_finish(benchmark::State& state) {
  const simulator::StockModel raw(kBlock, 0.1, kMemory_bytes);
  const simulator::Pass pass{ball(), dome_finish()};
  for (auto _ : state) benchmark::DoNotOptimize(find_collisions(raw, pass, 0.1, {2, nullptr, {}}));
}
BENCHMARK(find_collisions_finish)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
