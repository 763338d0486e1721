#include <benchmark/benchmark.h>

#include "simulator/instrument/dexel_stock.h"
#include "tests/benchmark/dome_finish.h"

namespace limitgauge::benchmarks {
namespace {

/// What each move of the shared finish stage takes; the argument is the spacing in micrometres.
void remove_finish(benchmark::State& state) {
  const simulator::DexelStock raw(kBlock, static_cast<double>(state.range(0)) / 1000);
  const simulator::Pass pass{ball(), dome_finish()};
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(pass, {2, nullptr, {}}));
}
BENCHMARK(remove_finish)->Arg(250)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
