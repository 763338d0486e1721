#include "engine/surface/offset_model.h"

#include "tests/engine/cages.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::surface;

TEST_CASE("the limit mesh of a paraboloid lies on it within its bound", "[property][surface]") {
  const double k = 0.01;
  const PatchModel model(test::paraboloid_cage(8, 10, k), {0.01, 3, 10}, {});
  for (std::size_t p = 0; p < model.patches().size(); ++p) {
    const auto& patch = model.patches()[p];
    const auto& limit = patch.limit;
    double chord = 0;
    for (int v = 0; v < limit.cells(); ++v)
      for (int u = 0; u < limit.cells(); ++u) {
        const Vec3 a = limit.points[limit.index(u, v)], b = limit.points[limit.index(u + 1, v + 1)];
        CHECK(a.z == Approx(k * (a.x * a.x + a.y * a.y)).margin(1e-12));
        const Vec3 middle = (a + b) * 0.5;
        chord = std::max(chord, middle.z - k * (middle.x * middle.x + middle.y * middle.y));
      }
    CHECK(chord > 0);
    // The normal distance is no more than the vertical one.
    CHECK(chord / std::sqrt(1 + 4 * k * k * 1800) <= patch.bounds.back().limit.own_mm * (1 + 1e-9));
    CHECK(patch.bounds.back().limit.own_mm <= 0.0025);
  }
}

TEST_CASE("offsets of a bowl meet their closed form", "[unit][surface]") {
  const double k = 0.01, radius = 3;
  const PatchModel model(test::paraboloid_cage(8, 10, k), {0.01, radius, 10}, {});
  const OffsetModel offset = sample_offset(model, radius, 0.01);
  for (std::size_t p = 0; p < model.patches().size(); ++p) {
    const auto& limit = model.patches()[p].limit;
    const int stride = limit.cells() >> offset.depths[p];
    for (int v = 0; v < offset.grids[p].rows; ++v)
      for (int u = 0; u < offset.grids[p].columns; ++u) {
        const Vec3 s = limit.points[limit.index(u * stride, v * stride)];
        const double w = std::sqrt(1 + 4 * k * k * (s.x * s.x + s.y * s.y));
        const Vec3 centre{s.x - 2 * k * s.x * radius / w, s.y - 2 * k * s.y * radius / w,
                          s.z + radius / w};
        CHECK(distance(offset.grids[p].at(u, v), centre) < 1e-10);
      }
  }
}

TEST_CASE("a horizontal section of a bowl is one closed circle", "[unit][section]") {
  const double k = 0.01;
  const PatchModel model(test::paraboloid_cage(10, 10, k), {0.01, 0, 10}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  // 0 < z < 16 stays inside |x|, |y| < 40; 4 goes through grid lines of the patches at x = ±20.
  const double z = GENERATE(1.0, 4.0, 9.7);
  const auto curves = section(model, mesh, {2, z});
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].closed);
  for (const Vec3& p : curves[0].points) {
    CHECK(p.z == z);
    // Chords over z by 0.0025 at most: over the radius by 0.0025 / (2 k r).
    const double r = std::sqrt(z / k);
    CHECK(std::hypot(p.x, p.y) == Approx(r).margin(1.1 * 0.0025 / (2 * k * r)));
  }
}

TEST_CASE("sections through cracks of unequal depth stay closed", "[property][section]") {
  // A bump on one side makes neighbouring patches differ in depth.
  model::Cage cage = test::grid_cage(
      8, 5, [](double x, double y) { return x == 1 && y == 1 ? 9.0 : -0.1 * (x * x + y * y); });
  const PatchModel model(cage, {0.01, 0, 10}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  const auto [low, high] = std::minmax_element(mesh.depths.begin(), mesh.depths.end());
  REQUIRE(*high > *low);
  for (int i = -60; i <= 20; ++i) {
    for (const auto& curve : section(model, mesh, {2, i * 0.07})) {
      if (curve.closed) continue;
      // An open curve ends at the open boundary only.
      for (const Vec3& end : {curve.points.front(), curve.points.back()})
        CHECK(std::max(std::abs(end.x), std::abs(end.y)) > 19);
    }
  }
}

TEST_CASE("a plane through extraordinary vertices gives whole curves", "[unit][section]") {
  const PatchModel model(test::cube_cage(10), {0.01, 0, 8}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  for (const int axis : {0, 1, 2})
    for (const double value : {-5.0, 0.0, 5.0}) {
      const auto curves = section(model, mesh, {axis, value});
      REQUIRE(curves.size() == 1);
      CHECK(curves[0].closed);
      for (const Vec3& p : curves[0].points) CHECK(p[axis] == value);
    }
}
