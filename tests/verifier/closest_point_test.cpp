#include "verifier/closest_point.h"

#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

double brute_force(const ReferenceSurface& surface, const Vec3& p, int steps) {
  double best = 1e300;
  for (int patch = 0; patch < surface.patch_count(); ++patch) {
    if (!surface.has_surface(patch)) continue;
    for (int j = 0; j <= steps; ++j)
      for (int i = 0; i <= steps; ++i)
        best = std::min(best, distance(p, surface
                                              .evaluate(patch, static_cast<double>(i) / steps,
                                                        static_cast<double>(j) / steps)
                                              .position));
  }
  return best;
}

}  // namespace

TEST_CASE("the closest point beats every sample and is on the surface", "[property]") {
  std::mt19937 random(7);
  for (const model::Cage& cage : {tests::star_cage(5, 4), tests::star_cage(3, 3),
                                  tests::cube_cage(), tests::paraboloid_cage(20, 0.02)}) {
    const ReferenceSurface surface(cage);
    const SurfaceCells cells(surface.tree(), 0.5);
    const model::Box3 box = surface.bounding_box().grown(4);
    std::uniform_real_distribution<double> part(0, 1);
    for (int n = 0; n < 25; ++n) {
      const Vec3 p = box.low + Vec3{part(random) * box.size().x, part(random) * box.size().y,
                                    part(random) * box.size().z};
      const auto found = closest_point(cells, p, 1e6);
      REQUIRE(found);
      const double brute = brute_force(surface, p, 40);
      CHECK(found->distance_mm <= brute + 1e-12);
      const SurfaceSample s = surface.evaluate(found->place.patch, found->place.u, found->place.v);
      CHECK(distance(s.position, found->place.point) < 1e-9);
      CHECK(distance(p, found->place.point) == Approx(found->distance_mm).margin(1e-12));
      // A grid of spacing h misses the foot by h²/2 over the distance at most, or by h at a rim.
      CHECK(found->distance_mm >= brute - 1.0);
    }
  }
}

TEST_CASE("feet of perpendiculars are told from boundary points", "[unit]") {
  const ReferenceSurface surface(tests::plane_cage(10, 0, 0));
  const SurfaceCells cells(surface.tree(), 0.5);
  const auto over = closest_point(cells, {3.3, -2.2, 1.5}, 5);
  REQUIRE(over);
  CHECK(over->perpendicular);
  CHECK(over->distance_mm == Approx(1.5));
  CHECK(distance(over->normal, {0, 0, 1}) < 1e-12);
  const auto beside = closest_point(cells, {13, 0.1, 4}, 10);
  REQUIRE(beside);
  CHECK_FALSE(beside->perpendicular);
  CHECK(beside->distance_mm == Approx(5));
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

}  // namespace limitgauge::verifier
