#include <benchmark/benchmark.h>

#include <optional>

#include "simulator/process/process_check.h"
#include "simulator/stock/stock_model.h"
#include "simulator/sweep/sweep_index.h"
#include "tests/benchmark/aircraft_stages.h"
#include "tests/benchmark/cut_floor.h"
#include "tests/benchmark/dome_finish.h"

namespace limitgauge::benchmarks {
namespace {

using simulator::StockModel;

constexpr std::size_t kMemory_bytes = std::size_t{12} << 30;
const model::RunControl kTwoThreads{2, nullptr, {}};

StockModel raw_block(std::int64_t voxel_um) {
  return {kBlock, static_cast<double>(voxel_um) / 1000, kMemory_bytes};
}

/// Cutting the shared finish stage; the argument is the voxel in micrometres.
void cut_finish(benchmark::State& state) {
  const StockModel raw = raw_block(state.range(0));
  const simulator::Pass pass{ball(), dome_finish()};
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(pass, kTwoThreads));
}
BENCHMARK(cut_finish)->Arg(250)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

/// CAMotics' path: 98,000 moves 0.25 mm long in 305 rows.
void cut_98000(benchmark::State& state) {
  const StockModel raw = raw_block(state.range(0));
  const simulator::Pass pass{ball(), dome_finish(65.0 / 305)};
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(pass, kTwoThreads));
  state.counters["moves"] = static_cast<double>(pass.path->moves.size());
}
BENCHMARK(cut_98000)->Arg(250)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

StockModel before_finish(std::int64_t voxel_um) {
  const AircraftStages& stages = aircraft_stages();
  return raw_block(voxel_um).cut(stages.rough, kTwoThreads).cut(stages.semi_finish, kTwoThreads);
}

/// A level set of its own: an empty path cuts a copy.
StockModel copy_of(const StockModel& stock) {
  const simulator::Pass air{ball(), std::make_shared<const model::Toolpath>()};
  return stock.cut(air, kTwoThreads);
}

/// The aircraft's finish stage out of what the stages before it left, cut where it stands as a job
/// does.
void cut_aircraft(benchmark::State& state) {
  const StockModel before = before_finish(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    std::optional<StockModel> stock = copy_of(before);
    state.ResumeTiming();
    stock = std::move(*stock).cut(aircraft_stages().finish, kTwoThreads);
    benchmark::DoNotOptimize(stock);
    state.PauseTiming();
    stock.reset();
    state.ResumeTiming();
  }
}
BENCHMARK(cut_aircraft)
    ->Arg(100)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// The same at 0.02 mm, once and without a copy; ratios.sh leaves out what is called huge.
void cut_aircraft_huge(benchmark::State& state) {
  StockModel stock = before_finish(20);
  for (auto _ : state) stock = std::move(stock).cut(aircraft_stages().finish, kTwoThreads);
  state.counters["bytes"] = static_cast<double>(stock.memory_bytes());
}
BENCHMARK(cut_aircraft_huge)
    ->Iterations(1)
    ->Repetitions(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The raw block, and reading the points of the finished stock's surface.
void raw_block_built(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(raw_block(state.range(0)));
}
BENCHMARK(raw_block_built)->Arg(50)->Unit(benchmark::kMillisecond)->UseRealTime();

void points_aircraft(benchmark::State& state) {
  const StockModel after = before_finish(state.range(0)).cut(aircraft_stages().finish, kTwoThreads);
  const model::Box3 surface{{-45, -40, -4}, {45, 40, 11}};
  std::size_t points = 0;
  for (auto _ : state) {
    points = 0;
    after.visit_surface_points(
        surface, [&](std::span<const simulator::StockPoint> some) { points += some.size(); },
        kTwoThreads);
  }
  state.counters["points"] = static_cast<double>(points);
}
BENCHMARK(points_aircraft)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One vectorised distance and one write for each voxel that the stage changes.
void cut_aircraft_floor(benchmark::State& state) {
  const StockModel before = before_finish(state.range(0));
  const StockModel after = before.cut(aircraft_stages().finish, kTwoThreads);
  const Places places = changed_places(before, after);
  std::vector<float> distances(places.size());
  for (auto _ : state) {
    write_distances(places, {}, kRadius_mm, kTwoThreads, distances);
    benchmark::DoNotOptimize(distances.data());
  }
  state.counters["voxels"] = static_cast<double>(places.size());
}
BENCHMARK(cut_aircraft_floor)
    ->Arg(100)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Growth with the voxels: the aircraft's finish stage out of the block.
void cut_growth_voxels(benchmark::State& state) {
  const StockModel raw = raw_block(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(aircraft_stages().finish, kTwoThreads));
}
BENCHMARK(cut_growth_voxels)
    ->Arg(400)
    ->Arg(200)
    ->Arg(100)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Growth with the moves: rows ever closer over the dome; the argument is their distance in
/// micrometres.
void cut_growth_moves(benchmark::State& state) {
  const StockModel raw = raw_block(200);
  const simulator::Pass pass{ball(), dome_finish(static_cast<double>(state.range(0)) / 1000)};
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(pass, kTwoThreads));
  state.counters["moves"] = static_cast<double>(pass.path->moves.size());
}
BENCHMARK(cut_growth_moves)
    ->Arg(400)
    ->Arg(200)
    ->Arg(100)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Five million moves: the tree over them, and all of the cut at 0.25 mm.
simulator::Pass five_million() {
  return {ball(), dome_finish(0.026, 0.04)};
}
void index_huge_5_million(benchmark::State& state) {
  const simulator::Pass pass = five_million();
  for (auto _ : state) {
    const simulator::SweepIndex index(pass, kTwoThreads);
    state.counters["bytes_a_move"] =
        static_cast<double>(index.memory_bytes()) / static_cast<double>(index.size());
  }
  state.counters["moves"] = static_cast<double>(pass.path->moves.size());
}
BENCHMARK(index_huge_5_million)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void cut_huge_5_million(benchmark::State& state) {
  const StockModel raw = raw_block(250);
  const simulator::Pass pass = five_million();
  for (auto _ : state) benchmark::DoNotOptimize(raw.cut(pass, kTwoThreads));
}
BENCHMARK(cut_huge_5_million)
    ->Iterations(1)
    ->Repetitions(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void check_process_finish(benchmark::State& state) {
  const StockModel raw = raw_block(100);
  const simulator::Pass pass{ball(), dome_finish()};
  simulator::ProcessLimits limits;
  limits.tolerance_mm = 0.1;
  for (auto _ : state) benchmark::DoNotOptimize(check_process(raw, pass, limits, kTwoThreads));
}
BENCHMARK(check_process_finish)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
