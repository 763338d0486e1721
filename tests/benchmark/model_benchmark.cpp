// What a cage costs by its faces: the engine's model and the exact surface of a wavy part, of quads
// and of triangles. Time and bytes of a face, and how they grow with the number of faces.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "engine/surface/finish_model.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::benchmarks {
namespace {

using model::Index;

/// n × n squares of 1.5 mm, each a quad or two triangles.
model::Cage wavy_cage(int n, bool triangles) {
  constexpr double kStep_mm = 1.5;
  model::Cage cage;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = kStep_mm * i, y = kStep_mm * j;
      cage.vertices.push_back({x, y, 6 * std::sin(x / 23) * std::cos(y / 19)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (triangles) {
        cage.add_face(std::array<Index, 3>{a, b, c});
        cage.add_face(std::array<Index, 3>{a, c, d});
      } else {
        cage.add_face(std::array<Index, 4>{a, b, c, d});
      }
    }
  return cage;
}

void exact_surface(benchmark::State& state, bool triangles) {
  const model::Cage cage = wavy_cage(static_cast<int>(state.range(0)), triangles);
  std::size_t bytes = 0;
  for (auto _ : state) bytes = verifier::ReferenceSurface(cage).memory_bytes();
  const auto faces = static_cast<double>(cage.face_count());
  state.counters["bytes_a_face"] = static_cast<double>(bytes) / faces;
  state.counters["seconds_a_face"] = benchmark::Counter(
      faces, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void engine_model(benchmark::State& state) {
  const model::Cage cage = wavy_cage(static_cast<int>(state.range(0)), false);
  constexpr double kPrecision_mm = 0.01, kBall_mm = 3;
  engine::surface::ModelRequest request;
  request.precision_mm = kPrecision_mm;
  request.largest_offset_mm = kBall_mm;
  int deepest = 0;
  for (auto _ : state)
    deepest = engine::surface::FinishModel(cage, request, {}).figures().depth_max;
  state.counters["depth_max"] = deepest;
  state.counters["seconds_a_face"] = benchmark::Counter(
      static_cast<double>(cage.face_count()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(exact_surface, quads, false)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact_surface, triangles, true)->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(engine_model)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limitgauge::benchmarks
