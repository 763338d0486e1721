#include "engine/surface/cell/corner_ring.h"

#include "engine/surface/patch_model.h"
#include "tests/engine/cages.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using engine::surface::PatchModel;
using model::Vec3;

namespace {

PatchModel model_of(const model::Cage& cage, double precision_mm = 0.01) {
  return PatchModel(cage, {precision_mm, 0, 8}, {});
}

// Masks are a few dozen products of numbers near one: rounding stays far below this.
constexpr double kRounding = 1e-13;

}  // namespace

TEST_CASE("limit masks of the cube meet their closed forms", "[unit][surface]") {
  const PatchModel model = model_of(test::cube_cage(1));
  for (const auto& patch : model.patches()) {
    const auto& limit = patch.limit;
    const int m = limit.cells();
    const Vec3 control = model.outer().points[model.outer().origin[patch.first_half_edge]];
    CHECK(distance(limit.points[0], control * 0.5) < kRounding);
    CHECK(length(limit.points[limit.index(m / 2, m / 2)]) == Approx(68.0 / 81).epsilon(1e-13));
    const Vec3 edge = limit.points[limit.index(m / 2, 0)];
    CHECK(std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)}) ==
          Approx(395.0 / 648).epsilon(1e-13));
  }
}

TEST_CASE("a cube's corner normal is its diagonal", "[unit][surface]") {
  const PatchModel model = model_of(test::cube_cage(1));
  for (const auto& patch : model.patches()) {
    const Vec3 expected = normalized(patch.limit.points[0]);
    CHECK(distance(patch.limit.normals[0], expected) < kRounding);
  }
}

TEST_CASE("a plane through a vertex of any valence stays a plane with its normal",
          "[unit][surface][slow]") {
  const int valence = GENERATE(3, 5, 6, 7, 8, 12, 30);
  const double slope = 0.3;
  const PatchModel model = model_of(test::flat_star_cage(valence, 10, slope));
  const Vec3 normal = normalized(Vec3{-slope, 0, 1});
  for (const auto& patch : model.patches())
    for (std::size_t i = 0; i < patch.limit.points.size(); ++i) {
      CHECK(std::abs(dot(patch.limit.points[i], normal)) < 1e-12);
      // Differences of control points down to a ten-thousandth of a millimetre, rounded at 10 mm.
      CHECK(distance(patch.limit.normals[i], normal) < 1e-8);
    }
}
