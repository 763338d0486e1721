#include <benchmark/benchmark.h>

#include "simulator/process_check.h"
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

void check_process_finish(benchmark::State& state) {
  const simulator::StockModel raw(kBlock, 0.1, kMemory_bytes);
  const simulator::Pass pass{ball(), dome_finish()};
  simulator::ProcessLimits limits;
  limits.tolerance_mm = 0.1;
  for (auto _ : state) benchmark::DoNotOptimize(check_process(raw, pass, limits, {2, nullptr, {}}));
}
BENCHMARK(check_process_finish)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
