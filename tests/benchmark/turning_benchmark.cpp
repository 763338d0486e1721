// Certifying a stage whose tool turns as it goes, beside the same cutter contacts with the tool
// upright. In: the spaces that were swept and both certificates, on two threads. Out: the surface
// and its cells, and what reach takes, which looks at other ways of the tool and is not the same
// question.
#include <benchmark/benchmark.h>

#include <cmath>

#include "tests/support/cages.h"
#include "tests/support/rasters.h"
#include "verifier/certificate/certificate.h"
#include "verifier/gate/verify.h"

namespace limitgauge::benchmarks {
namespace {

using model::Vec3;

constexpr double kHalf_mm = 10, kDomeBend = 0.02, kRow_mm = 0.3, kAlong_mm = 0.12;

/// Rows over z = −0.02·(x² + y²), one millimetre further than the surface. `lean` 0 keeps the tool
/// upright; of 1 it leads by 6 degrees and sways about the normal, 0.35 degrees a move.
verifier::Pass turning_rows(const model::Cutter& cutter, double lean) {
  model::Toolpath path;
  model::ToolAxes axes;
  tests::along_rows(kHalf_mm + 1, kRow_mm, kAlong_mm, [&](double x, double y) {
    const Vec3 n = model::normalized({2 * kDomeBend * x, 2 * kDomeBend * y, 1});
    const Vec3 sway{0.1 + 0.02 * std::sin(2.5 * y), 0.02 * std::cos(x), 0};
    const Vec3 axis = lean > 0 ? model::normalized(n + sway * lean) : Vec3{0, 0, 1};
    const double corner = cutter.corner_radius_mm, flat = cutter.radius_mm() - corner;
    const Vec3 across = model::normalized(n - axis * dot(n, axis));
    const Vec3 tip =
        Vec3{x, y, -kDomeBend * (x * x + y * y)} + n * corner + across * flat - axis * corner;
    if (path.moves.empty()) path.start = tip, axes.start = axis;
    tests::feed_to(path, tip);
    axes.to.push_back(axis);
  });
  verifier::Pass pass{cutter, tests::shared(std::move(path))};
  if (lean > 0) pass.axes = std::make_shared<const model::ToolAxes>(std::move(axes));
  return pass;
}

void certify_rows(benchmark::State& state, const model::Cutter& cutter, double lean) {
  const verifier::ReferenceSurface dome(tests::paraboloid_cage(kHalf_mm, -kDomeBend));
  const verifier::SurfaceCells cells(dome.tree(), 0.3);
  const verifier::Pass pass = turning_rows(cutter, lean);
  const model::Stock block = model::BoxStock{{-15, -15, -20}, {30, 30, 25}};
  // That nothing is out of reach, as a stage whose tool turns has it.
  const verifier::Reachability search =
      verifier::Reachability(cells, pass.cutter, 0, verifier::kContact_mm).among_others();
  const verifier::ReachMap map = verifier::classify_reach(cells, search, {1, 1}, {2, nullptr, {}});
  const verifier::ReachQuery reach({&search, 1}, map);
  verifier::CertificateRequest request;
  request.resolution_mm = static_cast<double>(state.range(0)) * 1e-6;
  request.largest_cell_count = 20'000'000;
  for (auto _ : state) {
    const verifier::RemovedSpace space(block, {&pass, 1});
    const auto certified = [&](verifier::Side side) {
      return certify(cells, space, side, &reach, request, {2, nullptr, {}});
    };
    const verifier::Certificate gouge = certified(verifier::Side::gouge);
    const verifier::Certificate uncut = certified(verifier::Side::uncut);
    state.counters["moves"] = static_cast<double>(pass.path->moves.size());
    state.counters["cells"] = static_cast<double>(gouge.cells + uncut.cells);
    state.counters["gouge_width_nm"] = gouge.figure_mm.width() * 1e6;
    state.counters["uncut_width_nm"] = uncut.figure_mm.width() * 1e6;
  }
}

model::Cutter bull() {
  return {"bull", model::CutterType::bull, 6, 1, 0, 20, {}, {}};
}
void certify_upright_ball(benchmark::State& state) {
  certify_rows(state, tests::ball_cutter(3), 0);
}
void certify_turning_ball(benchmark::State& state) {
  certify_rows(state, tests::ball_cutter(3), 1);
}
void certify_turning_bull(benchmark::State& state) {
  certify_rows(state, bull(), 1);
}
BENCHMARK(certify_upright_ball)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(certify_turning_ball)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(certify_turning_bull)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
