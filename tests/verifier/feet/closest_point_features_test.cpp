#include "verifier/feet/closest_point.h"

#include <algorithm>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

std::optional<double> signed_at(const SurfaceCells& cells, const Vec3& p) {
  return signed_distance_mm(cells, p, *closest_point(cells, p, 1e6));
}

}  // namespace

TEST_CASE("features of a cube by its sharpness", "[unit]") {
  const ReferenceSurface sharp(tests::sharp_cube(true)), lids(tests::sharp_cube(false)),
      smooth(tests::cube_cage());
  const SurfaceCells sharp_cells(sharp.tree(), 1), lid_cells(lids.tree(), 1),
      smooth_cells(smooth.tree(), 1);
  const auto at = [](const SurfaceCells& cells, const Vec3& p) {
    const auto found = closest_point(cells, p, 100);
    REQUIRE(found);
    CHECK_FALSE(found->open);
    return *found;
  };
  CHECK(at(sharp_cells, {2, 0.1, 0.2}).feature == SurfaceFeature::smooth);
  const ClosestPoint edge = at(sharp_cells, {3, 3, 0.2});
  CHECK(edge.feature == SurfaceFeature::crease);
  CHECK_FALSE(edge.perpendicular);
  CHECK(edge.distance_mm == Approx(std::sqrt(8.0)));
  CHECK(at(sharp_cells, {3, 3, 4}).feature == SurfaceFeature::corner);
  CHECK(at(smooth_cells, {3, 3, 3}).feature == SurfaceFeature::extraordinary_vertex);
  CHECK(at(smooth_cells, {3, 3, 3}).perpendicular);
  CHECK(at(smooth_cells, {3, 1, 0.5}).feature == SurfaceFeature::smooth);
  CHECK(at(lid_cells, {0, 3, 3}).feature == SurfaceFeature::crease);
  CHECK(at(lid_cells, {1.2, 1.2, 3}).feature == SurfaceFeature::crease);
}

TEST_CASE("the end of a crease in smooth surface is a dart; semi-sharp is smooth", "[unit]") {
  model::Cage cage = tests::plane_cage(10, 0, 0);
  cage.creases = {{{11, 12}, 10}, {{12, 13}, 2}};
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 1);
  const auto feature = [&](const Vec3& p) { return closest_point(cells, p, 100)->feature; };
  CHECK(feature({0, 0, 1}) == SurfaceFeature::dart);
  CHECK(feature({-2, 0, 1}) == SurfaceFeature::crease);
  CHECK(feature({-2, 1e-3, 1}) == SurfaceFeature::smooth);
  CHECK(feature({2, 0, 1}) == SurfaceFeature::smooth);
}

TEST_CASE("holes and polygons carry their features to their patches", "[unit]") {
  model::Cage cage = tests::plane_cage(10, 0, 0);
  cage.holes = {5};  // [−5, 0]²
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 1);
  const auto rim = closest_point(cells, {-1, -2.5, 1}, 100);
  REQUIRE(rim);
  CHECK(rim->feature == SurfaceFeature::boundary);
  CHECK(rim->distance_mm == Approx(std::sqrt(2.0)));
  model::Cage pentagon;
  for (int k = 0; k < 5; ++k)
    pentagon.vertices.push_back({std::cos(1.2566 * k), std::sin(1.2566 * k), 0});
  pentagon.add_face(std::array<model::Index, 5>{0, 1, 2, 3, 4});
  const ReferenceSurface plate(pentagon);
  const SurfaceCells plate_cells(plate.tree(), 1);
  const auto centre =
      closest_point(plate_cells, plate.evaluate(0, 1, 1).position + Vec3{0, 0, 1}, 9);
  REQUIRE(centre);
  CHECK(centre->feature == SurfaceFeature::extraordinary_vertex);
  CHECK(closest_point(plate_cells, {9, 1, 0}, 20)->feature == SurfaceFeature::boundary);
}

TEST_CASE("signed distances: outside positive, inside negative, beyond a boundary none", "[unit]") {
  const ReferenceSurface cube(tests::sharp_cube(true));
  const SurfaceCells cells(cube.tree(), 1);
  // The cube [−1, 1]³ in closed form.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-3, 3);
  for (int n = 0; n < 300; ++n) {
    const Vec3 p{part(random), part(random), part(random)};
    const double x = std::abs(p.x) - 1, y = std::abs(p.y) - 1, z = std::abs(p.z) - 1;
    const double outside = std::hypot(std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0));
    const double expected = outside > 0 ? outside : std::max({x, y, z});
    const auto found = signed_at(cells, p);
    REQUIRE(found);
    CAPTURE(p.x, p.y, p.z);
    CHECK(std::abs(*found - expected) < 1e-9);
  }
  const ReferenceSurface plane(tests::plane_cage(10, 0, 0));
  const SurfaceCells plane_cells(plane.tree(), 1);
  CHECK(signed_at(plane_cells, {1, 1, -2}).value() == Approx(-2));
  CHECK(signed_at(plane_cells, {10, 1, 2}).value() == Approx(2));
  CHECK_FALSE(signed_at(plane_cells, {12, 1, 2}).has_value());
}

// A rounded lens: two bulging lids joined in one sharp rim. From beyond the rim both normals lean
// away from the query, and either alone may give the wrong side.
TEST_CASE("the side at a crease does not depend on the patch that was found", "[property]") {
  const ReferenceSurface surface(tests::scaled(tests::sharp_cube(false), 10));
  const SurfaceCells cells(surface.tree(), 2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  for (int n = 0; n < 300; ++n) {
    const double turn = 6.2831853 * part(random), rise = 1.4 * (2 * part(random) - 1);
    const Vec3 away{std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise),
                    std::sin(rise)};
    CHECK(signed_at(cells, away * (20 + 30 * part(random))).value() > 0);
    CHECK(signed_at(cells, away * (3 * part(random))).value() < 0);
  }
}

}  // namespace limitgauge::verifier
