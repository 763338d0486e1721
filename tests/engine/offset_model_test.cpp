#include "engine/surface/offset_model.h"

#include <algorithm>

#include "model/geometry/segment.h"
#include "model/part/cage_obj.h"
#include "tests/engine/cages.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"

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

TEST_CASE("a side or a grid asked for alone is that of the whole model", "[unit][surface]") {
  const PatchModel model(model::read_cage_obj(tests::fixtures() / "torture" / "uneven-depths.obj"),
                         {0.01, 3, 10}, {});
  const double offset_mm = GENERATE(0.0, 3.0);
  const OffsetSampler sampler(model, 0.01);
  const OffsetModel whole = sample_offset(model, offset_mm, 0.01);
  const auto [least, most] = std::minmax_element(whole.depths.begin(), whole.depths.end());
  REQUIRE(*least < *most);
  for (int p = 0; p < sampler.patches(); ++p) {
    const Grid grid = sampler.grid(p, offset_mm);
    CHECK(grid.points == whole.grids[p].points);
    CHECK(grid.points.size() == sampler.grid_points(p));
    for (int side = 0; side < 4; ++side) {
      std::vector<Vec3> points;
      for (int t = 0; t < grid.columns; ++t)
        points.push_back(grid.points[side_index(side, t, grid.columns - 1)]);
      CHECK(sampler.side(p, side, offset_mm) == points);
    }
  }
}

TEST_CASE("finer sides lie on the chords of their coarser neighbours", "[unit][surface]") {
  const PatchModel model(model::read_cage_obj(tests::fixtures() / "torture" / "uneven-depths.obj"),
                         {0.01, 3, 10}, {});
  const OffsetSampler sampler(model, 0.01);
  int laid = 0;
  for (Index h = 0; h < model.outer().half_edge_count(); ++h) {
    if (!model.has_patch(h) || model.ends_at(h) || model.creased_at(h)) continue;
    const Index twin = model.outer().twin[h];
    const auto fine = sampler.side(model.patch_at(h), model.side_at(h), 3);
    const auto coarse = sampler.side(model.patch_at(twin), model.side_at(twin), 3);
    if (fine.size() <= coarse.size()) continue;
    const std::size_t ratio = (fine.size() - 1) / (coarse.size() - 1);
    for (std::size_t t = 0; t < fine.size(); ++t) {
      const std::size_t from = std::min(t / ratio, coarse.size() - 2);
      const Vec3 &a = coarse[coarse.size() - 1 - from], &b = coarse[coarse.size() - 2 - from];
      CHECK(distance_to_segment(fine[t], a, b) < 1e-12 * length(model.bounding_box().size()));
    }
    ++laid;
  }
  CHECK(laid > 0);
}
