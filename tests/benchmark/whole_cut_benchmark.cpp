// All that a job does with a stage's cut: the level set, the second instrument, the two held
// against each other, the points of the surface. Phase by phase in seconds, so that growth is seen
// where it is.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <optional>

#include "model/base/memory.h"
#include "simulator/instrument/dexel_agreement.h"
#include "simulator/instrument/dexel_stock.h"
#include "simulator/stock/stock_model.h"
#include "tests/benchmark/dome_finish.h"

namespace limitgauge::benchmarks {
namespace {

using simulator::StockModel;

const model::RunControl kBothCores{2, nullptr, {}};
constexpr std::size_t kLimit_bytes = std::size_t{5} << 30, kLines = 4000;

struct Finish {
  model::Stock stock;
  simulator::Pass pass;
  model::Box3 surface;  ///< where points are read
  double voxel_mm = 0;
};

/// Processor seconds of all threads that `work` takes, the mean of the iterations.
template <class Work>
void time(benchmark::State& state, const char* phase, const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  state.counters[phase].flags = benchmark::Counter::kAvgIterations;
  state.counters[phase].value += seconds;
}

void cut_whole(benchmark::State& state, const Finish& finish) {
  std::optional<StockModel> stock(std::in_place, finish.stock, finish.voxel_mm, kLimit_bytes,
                                  kBothCores);
  const double spacing =
      simulator::removal_spacing_mm(finish.voxel_mm, finish.stock, {finish.pass});
  std::optional<simulator::DexelStock> lines(std::in_place, finish.stock, spacing);
  time(state, "cut_s", [&] { stock = std::move(*stock).cut(finish.pass, kBothCores); });
  time(state, "lines_s", [&] { lines = lines->cut(finish.pass, kBothCores).stock; });
  time(state, "agree_s", [&] {
    const auto found = compare_stocks(*lines, *stock, kLines, kBothCores);
    if (!found.agree()) state.SkipWithError("the instruments disagree");
  });
  std::size_t points = 0;
  time(state, "points_s", [&] {
    stock->visit_surface_points(
        finish.surface, [&](std::span<const simulator::StockPoint> some) { points += some.size(); },
        kBothCores);
  });
  state.counters["points"] = static_cast<double>(points);
  state.counters["tiles"] = static_cast<double>(stock->tiles());
}

/// CAMotics' path: 98,000 moves 0.25 mm long in 305 rows; the argument is the voxel in micrometres.
void whole_98000(benchmark::State& state) {
  const Finish finish{kBlock,
                      {ball(), dome_finish(65.0 / 305)},
                      {{-40, -32.5, -14}, {40, 32.5, 1}},
                      static_cast<double>(state.range(0)) / 1000};
  for (auto _ : state) cut_whole(state, finish);
  state.counters["moves"] = static_cast<double>(finish.pass.path->moves.size());
}
BENCHMARK(whole_98000)
    ->Arg(250)
    ->Arg(100)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
