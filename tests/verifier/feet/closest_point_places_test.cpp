#include "verifier/feet/closest_point.h"

#include <algorithm>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {

using model::Vec3;

TEST_CASE("feet of perpendiculars are told from boundary points", "[unit]") {
  const ReferenceSurface surface(tests::plane_cage(10, 0, 0));
  const SurfaceCells cells(surface.tree(), 0.5);
  const auto over = closest_point(cells, {3.3, -2.2, 1.5}, 5);
  REQUIRE(over);
  CHECK(over->perpendicular);
  CHECK(over->feature == SurfaceFeature::smooth);
  CHECK(over->distance_mm == Approx(1.5));
  CHECK(distance(over->normal, {0, 0, 1}) < 1e-12);
  const auto beside = closest_point(cells, {13, 0.1, 4}, 10);
  REQUIRE(beside);
  CHECK_FALSE(beside->perpendicular);
  CHECK(beside->feature == SurfaceFeature::boundary);
  CHECK(beside->open);
  CHECK(beside->distance_mm == Approx(5));
  const auto off_corner = closest_point(cells, {13, 14, 12}, 20);
  REQUIRE(off_corner);
  CHECK(off_corner->feature == SurfaceFeature::corner);
  CHECK(off_corner->open);
  CHECK(off_corner->distance_mm == Approx(13));
  CHECK_FALSE(closest_point(cells, {13, 0, 4}, 4.9));
}

TEST_CASE("distance to a paraboloid along its normal", "[unit]") {
  const double k = 0.02;
  const ReferenceSurface surface(tests::paraboloid_cage(20, k));
  const SurfaceCells cells(surface.tree(), 0.5);
  for (const double x : {0.0, 3.0, 7.7, 15.0})
    for (const double off : {-2.0, -0.01, 0.01, 5.0}) {
      const Vec3 s{x, 1.0, k * (x * x + 1)}, n = normalized(Vec3{-2 * k * x, -2 * k, 1});
      const auto found = closest_point(cells, s + n * off, 20);
      REQUIRE(found);
      CAPTURE(x, off);
      CHECK(found->distance_mm == Approx(std::abs(off)).margin(1e-11));
      CHECK(distance(found->place.point, s) < 1e-9);
    }
}

// Where the query stands nearer than the centres of curvature and the rest of the part, the foot is
// known. Distances are level about a foot: next to the end of a cell they do not tell its place to
// better than 1e-8 mm.
TEST_CASE("places are exact beside the ends of cells, vertices and boundaries too", "[property]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> part(0, 1);
  for (const model::Cage& cage :
       {tests::star_cage(3, 1), tests::star_cage(5, 1), tests::star_cage(8, 1),
        tests::paraboloid_cage(20, 0.02), tests::scaled(tests::sharp_cube(true), 10)}) {
    const ReferenceSurface surface(cage);
    const SurfaceCells cells(surface.tree(), 2);
    for (int n = 0; n < 300; ++n) {
      const int patch = static_cast<int>(random() % static_cast<unsigned>(surface.patch_count()));
      if (!surface.has_surface(patch)) continue;
      const auto parameter = [&] {
        const double at = static_cast<double>(random() % 5) / 4;  // an end of a cell
        const double beside = std::pow(10.0, -12 * part(random));
        return std::clamp(n % 3 == 0 ? part(random) : at + (at < 1 ? beside : -beside), 0.0, 1.0);
      };
      const double u = parameter(), v = parameter();
      // Pieces so near to a vertex are too small for their normals to be known from coordinates.
      const double off_u = std::min(u, 1 - u), off_v = std::min(v, 1 - v);
      if (std::max(off_u, off_v) < 1e-6 && off_u + off_v > 0) continue;
      const SurfaceSample s = surface.evaluate(patch, u, v);
      // The curvature of the stars grows without bound towards their vertices, slowly.
      const double off = 0.01 * part(random);
      CAPTURE(patch, n, off, s.position.x, s.position.y, s.position.z);
      const auto found = closest_point(cells, s.position + s.normal * off, 10);
      REQUIRE(found);
      CHECK(distance(found->place.point, s.position) < 1e-9);
      CHECK(std::abs(found->distance_mm - off) < 1e-9);
      const Vec3 to = s.position + s.normal * off - found->place.point;
      CHECK(length(cross(to, s.normal)) < 1e-9);
    }
  }
}

// On the axis of z = k·r², from the centre of curvature 1/(2k) upwards, the feet are a circle at
// height z − 1/(2k), √(z/k − 1/(4k²)) away. At the centre itself the distance is level to the
// fourth order.
TEST_CASE("a query at and beyond a centre of curvature gets the distance", "[unit]") {
  const double k = 0.05;
  const ReferenceSurface surface(tests::paraboloid_cage(20, k));
  const SurfaceCells cells(surface.tree(), 0.5);
  for (const double above : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 3.0}) {
    const double z = 1 / (2 * k) + above;
    const auto found = closest_point(cells, {0, 0, z}, 100);
    REQUIRE(found);
    CAPTURE(above);
    CHECK(std::abs(found->distance_mm - std::sqrt(z / k - 1 / (4 * k * k))) < 1e-9);
  }
}

TEST_CASE("two feet in one cell are both found", "[unit]") {
  // A trough z = k·x² seen from near its axis, high up: a foot on either side of the middle.
  const double k = 0.05, h = 10;
  const model::Cage cage = tests::grid_cage(
      4, 4,
      [=](int i, int j) {
        const double a = i - 1.5, b = j - 1.5;
        return Vec3{a * h, b * h, k * h * h * (a * a - 1.0 / 3)};
      },
      model::BoundaryRule::none);
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 20);
  for (const double aside : {-1e-3, -1e-7, 1e-7, 1e-3}) {
    const auto found = closest_point(cells, {aside, 0.3, 10.5}, 100);
    REQUIRE(found);
    CAPTURE(aside);
    CHECK(found->place.point.x * aside > 0);
    CHECK(std::abs(found->place.point.y - 0.3) < 1e-9);
  }
}

}  // namespace limitgauge::verifier
