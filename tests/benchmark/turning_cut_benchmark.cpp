// Cutting stock by a tool that turns as it goes. In: the tree of the moves and the level set, on
// two threads. Out: the raw stock.
#include <benchmark/benchmark.h>

#include <cmath>

#include "model/base/memory.h"
#include "simulator/stock/stock_model.h"
#include "tests/support/rasters.h"

namespace limitgauge::benchmarks {
namespace {

using model::Vec3;

constexpr double kBend = 0.01, kMost_mm = 30, kRows_mm = 0.3, kStep_mm = 0.24;

/// Rows over z = −0.01·(x² + y²), 60 mm wide, some 50,000 moves of a quarter of a millimetre. The
/// tool leads by 6 degrees and sways about the normal by a degree a millimetre.
simulator::Pass swaying_rows(const model::Cutter& cutter, bool turns) {
  model::Toolpath path;
  model::ToolAxes axes;
  tests::along_rows(kMost_mm, kRows_mm, kStep_mm, [&](double x, double y) {
    const Vec3 n = model::normalized({2 * kBend * x, 2 * kBend * y, 1});
    const Vec3 sway{0.1 + 0.02 * std::sin(y), 0.02 * std::cos(x), 0};
    const Vec3 axis = turns ? model::normalized(n + sway) : Vec3{0, 0, 1};
    const double corner = cutter.corner_radius_mm, flat = cutter.radius_mm() - corner;
    const Vec3 across = n - axis * dot(n, axis);
    const Vec3 level = length(across) > 0 ? model::normalized(across) : Vec3{};
    const Vec3 tip =
        Vec3{x, y, -kBend * (x * x + y * y)} + n * corner + level * flat - axis * corner;
    if (path.moves.empty()) path.start = tip, axes.start = axis;
    tests::feed_to(path, tip);
    axes.to.push_back(axis);
  });
  simulator::Pass pass{cutter, tests::shared(std::move(path))};
  if (turns) pass.axes = std::make_shared<const model::ToolAxes>(std::move(axes));
  return pass;
}

void cut_rows(benchmark::State& state, const char* cutter, bool turns) {
  const double voxel = static_cast<double>(state.range(0)) * 1e-3;
  const simulator::Pass pass = swaying_rows(model::parse_cutter(cutter), turns);
  const model::Stock block = model::BoxStock{{-32, -32, -30}, {64, 64, 31}};
  const model::RunControl control{2, nullptr, {}};
  const simulator::StockModel raw(block, voxel, std::size_t{4} << 30, control);
  for (auto _ : state) {
    const simulator::StockModel cut = raw.cut(pass, control);
    state.counters["moves"] = static_cast<double>(pass.path->moves.size());
    state.counters["stock_MiB"] = static_cast<double>(cut.memory_bytes()) / (1 << 20);
  }
}

void cut_upright_ball(benchmark::State& state) {
  cut_rows(state, "ball:D=6,L=20", false);
}
void cut_turning_ball(benchmark::State& state) {
  cut_rows(state, "ball:D=6,L=20", true);
}
void cut_turning_bull(benchmark::State& state) {
  cut_rows(state, "bull:D=6,r=1,L=20", true);
}
void cut_turning_flat(benchmark::State& state) {
  cut_rows(state, "flat:D=6,L=20", true);
}
BENCHMARK(cut_upright_ball)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cut_turning_ball)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cut_turning_bull)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cut_turning_flat)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
