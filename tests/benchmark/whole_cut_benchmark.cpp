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

/// The tip of a ball that touches the waves z = 5 sin(x/10) cos(y/10), whose radius is nowhere
/// below 10 mm, in the point over (x, y).
model::Vec3 wave_tip(double x, double y) {
  const double sx = std::sin(x / 10), cx = std::cos(x / 10);
  const double sy = std::sin(y / 10), cy = std::cos(y / 10);
  const model::Vec3 normal = normalized(model::Vec3{-0.5 * cx * cy, 0.5 * sx * sy, 1});
  return model::Vec3{x, y, 5 * sx * cy} + normal * kRadius_mm - model::Vec3{0, 0, kRadius_mm};
}

std::shared_ptr<const model::Toolpath> wave_finish(double reach, double row_mm, double along_mm) {
  auto path = std::make_shared<model::Toolpath>();
  path->start = wave_tip(-reach, -reach) + model::Vec3{0, 0, 30};
  double side = -1;
  for (double y = -reach; y <= reach; y += row_mm, side = -side)
    for (double x = -reach; x <= reach; x += along_mm)
      path->moves.push_back({wave_tip(-side * x, y), 1000,
                             static_cast<std::uint32_t>(path->moves.size() + 1),
                             model::MoveKind::feed});
  return path;
}

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

/// Of the square that the surface lies over.
double surface_voxels(const Finish& finish) {
  const model::Vec3 size = finish.surface.size();
  return size.x * size.y / (finish.voxel_mm * finish.voxel_mm);
}

void cut_whole(benchmark::State& state, const Finish& finish) {
  model::reset_process_peak();
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
  state.counters["moves"] = static_cast<double>(finish.pass.path->moves.size());
  state.counters["voxels"] = surface_voxels(finish);
  state.counters["peak_bytes"] = static_cast<double>(model::process_peak_bytes());
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
}
BENCHMARK(whole_98000)
    ->Arg(250)
    ->Arg(100)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// A raster over waves of 10 mm on a block of 80 mm height. Arguments: the block's side in mm, the
/// distance of rows and the voxel in micrometres. The first has five million moves, the others show
/// how it grows with moves and with voxels (block_growth.py).
void block_huge(benchmark::State& state) {
  const double side = static_cast<double>(state.range(0));
  const double row = static_cast<double>(state.range(1)) / 1000;
  const double half = side / 2, reach = half - 0.5 * row;
  const Finish finish{model::BoxStock{{-half, -half, -74}, {side, side, 80}},
                      {ball(), wave_finish(reach, row, 1.8 * row)},
                      {{-half, -half, -6}, {half, half, 6}},
                      static_cast<double>(state.range(2)) / 1000};
  for (auto _ : state) cut_whole(state, finish);
}
BENCHMARK(block_huge)
    ->Args({75, 100, 100})
    ->Args({75, 50, 100})
    ->Args({75, 100, 50})
    ->Args({300, 100, 100})
    ->Iterations(1)
    ->Repetitions(1)
    ->Unit(benchmark::kSecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
