// Refining the aircraft's cage by CELL and by others, from the cage each time on all sides: its
// outer layer, CGAL's mesh and OpenSubdiv's base level are built within the time. One thread each.
// The refined meshes are checked to hold the same points.
#include <benchmark/benchmark.h>

#include "tests/benchmark/refined_meshes.h"

namespace limitgauge::benchmarks {
namespace {

using engine::surface::FloatPoint;
using model::Vec3;

constexpr int kTimeDepth = 7;

template <class Point>
void cell_refine(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(cell_patches<Point>(kTimeDepth));
}
BENCHMARK(cell_refine<Vec3>)->Name("cell_refine")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cell_refine<FloatPoint>)
    ->Name("cell_refine_float")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void cell_refine_cgal(benchmark::State& state) {
  if (largest_gap(points_of(cell_patches<Vec3>(kTimeDepth)), points_of(cgal_refined(kTimeDepth))) >
      1e-9)
    return state.SkipWithError("the meshes differ");
  for (auto _ : state) benchmark::DoNotOptimize(cgal_refined(kTimeDepth));
}
BENCHMARK(cell_refine_cgal)->Unit(benchmark::kMillisecond)->UseRealTime();

void cell_refine_opensubdiv(benchmark::State& state) {
  std::vector<Vec3> points;
  for (const FarPoint& p : far_refined(kTimeDepth)) points.push_back({p.x, p.y, p.z});
  if (largest_gap(points_of(cell_patches<FloatPoint>(kTimeDepth)), points) > 1e-4)
    return state.SkipWithError("the meshes differ");
  for (auto _ : state) benchmark::DoNotOptimize(far_refined(kTimeDepth));
}
BENCHMARK(cell_refine_opensubdiv)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
