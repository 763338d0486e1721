#include "verifier/gate/stock_rays.h"

#include <functional>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

const model::Stock kRayBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
constexpr double kRayRadius = 3, kStep = 0.4;

/// A stock of which a function says where its material is, asked in small steps and then halved:
/// slow, and nothing like the simulator.
class FunctionStock : public StockProbe {
 public:
  using Inside = std::function<bool(const Vec3&)>;
  explicit FunctionStock(Inside inside) : inside_(std::move(inside)) {}
  Run run(const Vec3& from, const Vec3& along, double limit_mm) const override {
    constexpr double kStep_mm = 0.003;
    const bool first = inside_(from);
    double low = 0;
    for (double t = kStep_mm;; t += kStep_mm) {
      const double at = std::min(t, limit_mm);
      if (inside_(from + along * at) != first) return ended(from, along, first, low, at);
      if (at >= limit_mm) return {first, limit_mm, false, 0};
      low = at;
    }
  }
  double spacing_mm() const override { return 0.05; }

 private:
  Run ended(const Vec3& from, const Vec3& along, bool first, double low, double high) const {
    while (high - low > 1e-10) {
      const double middle = (low + high) / 2;
      (inside_(from + along * middle) == first ? low : high) = middle;
    }
    return {first, low, true, 1e-10};
  }
  Inside inside_;
};

/// A ball raster over the plane z = 0, `sunk` below it, and the stock that it leaves: closed form.
struct Bench {
  explicit Bench(double sunk_mm = 0) : sunk(sunk_mm), plane(plane_cage(4, 0, 0)) {
    pass = {ball_cutter(kRayRadius),
            shared(raster(6, kStep, 12, [&](double, double) { return -sunk; }))};
    check.resolution_mm = 0.0005;
    check.field_spacing_mm = 0.2;
  }
  double stock_z(double x) const {
    const double row = std::remainder(x + 6, kStep);
    return kRayRadius - std::sqrt(kRayRadius * kRayRadius - row * row) - sunk;
  }
  FunctionStock::Inside cut() const {
    return [this](const Vec3& p) { return p.z < stock_z(p.x); };
  }
  StageDeviation measure(FunctionStock::Inside stock) const {
    const FunctionStock probe(std::move(stock));
    return measure_stage(plane, kRayBlock, {&pass, 1}, &probe, check, {2});
  }

  double sunk;
  ReferenceSurface plane;
  Pass pass;
  StageCheck check;
};

std::string disagreement(const Bench& bench, FunctionStock::Inside stock) {
  try {
    bench.measure(std::move(stock));
  } catch (const InstrumentDisagreement& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("rays into the true stock agree and give the runs along the normals", "[unit]") {
  const Bench clean;
  const StageDeviation d = clean.measure(clean.cut());
  CHECK(d.voxel_gouge_mm == Approx(0).margin(1e-9));
  // Samples stand 0.2 mm apart, every second one on a cusp.
  const double cusp = kRayRadius - std::sqrt(kRayRadius * kRayRadius - kStep * kStep / 4);
  CHECK(d.voxel_uncut_mm == Approx(cusp).margin(1e-9));
  const Bench sunk(0.01);
  const StageDeviation deep = sunk.measure(sunk.cut());
  CHECK(deep.voxel_gouge_mm == Approx(0.01).margin(1e-9));
  CHECK(deep.voxel_uncut_mm == 0);
}

TEST_CASE("a stock that is not what was removed ends the run with both readings", "[unit]") {
  const Bench bench;
  for (const double off : {2e-5, -2e-5, 0.01}) {
    const std::string message =
        disagreement(bench, [&](const Vec3& p) { return p.z < bench.stock_z(p.x) + off; });
    CAPTURE(off, message);
    CHECK(message.find("disagree") != std::string::npos);
    CHECK(message.find("analytic instrument") != std::string::npos);
    CHECK(message.find("voxel instrument") != std::string::npos);
  }
  CHECK(disagreement(bench, bench.cut()).empty());
}

TEST_CASE("a fin between two cuts reads its height, one milled away its thickness", "[unit]") {
  // Flats of D4 pass at a step of 4 mm and 2 µm: the fin is 5 mm tall, and stands over x = 0.
  const ReferenceSurface plane(plane_cage(4, 0, 0));
  model::Toolpath path;
  const double w = 0.002;
  path.start = {-2 - w / 2, -10, 0};
  feed_to(path, {-2 - w / 2, 10, 0});
  feed_to(path, {2 + w / 2, 10, 6});
  feed_to(path, {2 + w / 2, 10, 0});
  feed_to(path, {2 + w / 2, -10, 0});
  const Pass pass{flat_cutter(2), shared(path)};
  const model::Stock block = model::BoxStock{{-20, -20, -10}, {40, 40, 15}};
  const FunctionStock stock([&](const Vec3& p) {
    if (p.z < 0) return true;
    return p.z < 5 && std::abs(p.x) < w / 2;
  });
  const SurfaceCells cells(plane.tree(), 0.3);
  const RemovedSpace removed(block, {&pass, 1}), raw(block, {});
  const RayScene scene{cells, removed, raw, stock, 40};
  CHECK(read_ray(scene, {0, 1, 0}, {0, 0, 1}, 0).uncut_mm == Approx(5).margin(1e-6));
  CHECK(read_ray(scene, {0.01, 1, 0}, {0, 0, 1}, 0).uncut_mm == Approx(0).margin(1e-6));
  // The same fin as part of S would be: a run inwards ends where it comes out again.
  CHECK(read_ray(scene, {1, 1, 4}, {1, 0, 0}, 0).gouge_mm == Approx(1 - w / 2).margin(1e-6));
}

TEST_CASE("nothing is read where the raw stock does not cover S", "[unit]") {
  const ReferenceSurface plane(plane_cage(4, 0, 0));
  const Pass pass{ball_cutter(3), shared(raster(5, 1, 10, [](double, double) { return 20.0; }))};
  const model::Stock block = model::BoxStock{{-20, -20, -10}, {40, 40, 9}};
  const FunctionStock stock([](const Vec3& p) { return p.z < -1; });
  const SurfaceCells cells(plane.tree(), 0.3);
  const RemovedSpace removed(block, {&pass, 1}), raw(block, {});
  const RayReading r = read_ray({cells, removed, raw, stock, 40}, {0, 0, 0}, {0, 0, 1}, 0);
  CHECK(r.gouge_mm == 0);
  CHECK(r.uncut_mm == 0);
}

}  // namespace limitgauge::verifier
