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
    CHECK(chord / std::sqrt(1 + 4 * k * k * 1800) <=
          patch.bounds.at.back().limit.own_mm * (1 + 1e-9));
    CHECK(patch.bounds.at.back().limit.own_mm <= 0.0025);
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
