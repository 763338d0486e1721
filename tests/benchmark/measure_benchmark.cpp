#include <benchmark/benchmark.h>

#include "tests/benchmark/dome_finish.h"
#include "tests/support/cages.h"
#include "tests/support/solid_meshes.h"
#include "verifier/certificate/certificate.h"
#include "verifier/feet/closest_point.h"
#include "verifier/gate/verify.h"

namespace limitgauge::benchmarks {
namespace {

/// A waved casting of 200,000 triangles whose skin stands about `above_mm` over the dome.
model::Stock casting(double above_mm) {
  return tests::mesh_stock(tests::block_under(45, 222, -22, [=](double x, double y) {
    return above_mm - kBend * (x * x + y * y) + 0.05 * std::sin(x) * std::cos(y);
  }));
}

/// Certifying the shared finish stage on a dome of 60 × 60 mm out of `stock`; the argument is the
/// width asked for in nanometres.
void certify_out_of(benchmark::State& state, const model::Stock& stock) {
  const verifier::ReferenceSurface dome(tests::paraboloid_cage(30, -kBend));
  const verifier::SurfaceCells cells(dome.tree(), 0.3);
  const verifier::Pass pass{ball(), dome_finish()};
  const verifier::RemovedSpace space(stock, {&pass, 1});
  const verifier::Reachability search(cells, verifier::CutterProfile(pass.cutter), 0,
                                      verifier::kContact_mm);
  const verifier::ReachMap proven =
      verifier::classify_reach(cells, search, verifier::kReachEffort, {2, nullptr, {}});
  const verifier::ReachQuery reach({&search, 1}, proven);
  verifier::CertificateRequest request;
  request.resolution_mm = static_cast<double>(state.range(0)) * 1e-6;
  request.largest_cell_count = 20'000'000;
  for (auto _ : state) {
    const verifier::Certificate gouge =
        certify(cells, space, verifier::Side::gouge, nullptr, request, {2, nullptr, {}});
    const verifier::Certificate uncut =
        certify(cells, space, verifier::Side::uncut, &reach, request, {2, nullptr, {}});
    state.counters["cells"] = static_cast<double>(gouge.cells + uncut.cells);
    state.counters["uncut_width_nm"] = uncut.figure_mm.width() * 1e6;
  }
}
void certify_finish(benchmark::State& state) {
  certify_out_of(state, kBlock);
}
BENCHMARK(certify_finish)
    ->Arg(1000)
    ->Arg(300)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
void certify_finish_of_casting(benchmark::State& state) {
  certify_out_of(state, casting(1.2));
}
BENCHMARK(certify_finish_of_casting)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

void closest_point_queries(benchmark::State& state) {
  const verifier::ReferenceSurface dome(tests::paraboloid_cage(30, -kBend));
  const verifier::SurfaceCells cells(dome.tree(), 0.3);
  double turn = 0;
  for (auto _ : state) {
    turn += 0.7548776662466927;  // steps that fill the interval evenly
    const double x = 56 * (turn - std::floor(turn)) - 28,
                 y = 56 * (17 * turn - std::floor(17 * turn)) - 28;
    benchmark::DoNotOptimize(closest_point(cells, {x, y, 0.5 - kBend * (x * x + y * y)}, 5));
  }
}
BENCHMARK(closest_point_queries);

}  // namespace
}  // namespace limitgauge::benchmarks
