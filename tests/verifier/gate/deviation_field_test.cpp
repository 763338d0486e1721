#include "verifier/gate/deviation_field.h"

#include <cmath>

#include "tests/support/cages.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::verifier;

TEST_CASE("the grids of a field say where its samples are", "[unit][field]") {
  // Patches of the outermost ring carry no surface: the numbers of the others have gaps.
  const ReferenceSurface dome(tests::paraboloid_cage(6, -0.05));
  const DeviationField field = sample_surface(dome, 0.7);
  REQUIRE(field.grids.size() == 36);
  std::size_t samples = 0, cells = 0;
  for (const DeviationField::Grid& grid : field.grids) {
    REQUIRE(grid.first == samples);
    REQUIRE(dome.has_surface(grid.patch));
    for (std::uint32_t j = 0; j < grid.rows; ++j)
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        const SurfacePlace& place = field.samples.at(samples++).place;
        REQUIRE(place.patch == grid.patch);
        REQUIRE(place.u == double(i) / (grid.columns - 1));
        REQUIRE(place.v == double(j) / (grid.rows - 1));
      }
    cells += std::size_t(grid.columns - 1) * (grid.rows - 1);
  }
  CHECK(samples == field.samples.size());
  CHECK(cells == field.quads.size());
}

TEST_CASE("neighbouring samples are within the spacing, and share out the area", "[unit][field]") {
  const ReferenceSurface plane(tests::plane_cage(8, 1, 0));
  const DeviationField field = sample_surface(plane, 0.5);
  double area = 0;
  for (const auto& sample : field.samples) area += static_cast<double>(sample.area_mm2);
  CHECK(area == Approx(16 * 16 * std::sqrt(2.0)).epsilon(1e-5));
  for (const auto& quad : field.quads)
    for (int k = 0; k < 4; ++k) {
      const auto& a = field.samples[quad[k]].place.point;
      const auto& b = field.samples[quad[(k + 1) % 4]].place.point;
      // Edges of the cage's border patches are not evenly run through.
      REQUIRE(distance(a, b) < 2 * 0.5);
    }
}
