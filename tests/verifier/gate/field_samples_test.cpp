#include "verifier/gate/field_samples.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/solid_meshes.h"

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

namespace {

/// One facet, its corners beginning with number `first`.
ReferenceSurface facet_surface(const std::array<model::Vec3, 3>& corners, int first = 0) {
  model::TriangleMesh mesh;
  for (int k = 0; k < 3; ++k) mesh.vertices.push_back(corners[(k + first) % 3]);
  mesh.triangles = {{0, 1, 2}};
  return ReferenceSurface(mesh);
}

double nearest_sample_mm(const DeviationField& field, const model::Vec3& p) {
  double nearest = 1e300;
  for (const auto& s : field.samples) nearest = std::min(nearest, distance(s.place.point, p));
  return nearest;
}

/// Long and thin ones, blunt and acute ones, some with the corner opposite right above an end.
std::array<model::Vec3, 3> some_facet(std::mt19937& random, int i) {
  std::uniform_real_distribution<double> share(0, 1);
  const double length = std::pow(40.0, share(random)), height = std::pow(10.0, -3 * share(random));
  const double foot = i % 4 == 0 ? 0 : i % 4 == 1 ? 1 : share(random);
  const double turn = 6 * share(random), lean = 3 * share(random);
  const auto place = [&](double x, double y) {
    const double a = std::cos(turn) * x - std::sin(turn) * y,
                 b = std::sin(turn) * x + std::cos(turn) * y;
    return model::Vec3{a, std::cos(lean) * b, std::sin(lean) * b};
  };
  return {place(0, 0), place(length, 0), place(foot * length, height * length)};
}

}  // namespace

TEST_CASE("samples of a facet are as many as its area asks for, and near every point of it",
          "[unit][field]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  constexpr double kSpacing_mm = 0.5;
  for (int i = 0; i < 60; ++i) {
    const auto corners = some_facet(random, i);
    const ReferenceSurface facet = facet_surface(corners, i % 3);
    const DeviationField field = sample_surface(facet, kSpacing_mm);
    double area = 0, longest = 0;
    for (const auto& s : field.samples) {
      area += static_cast<double>(s.area_mm2);
      const auto at = facet.evaluate(s.place.patch, s.place.u, s.place.v).position;
      REQUIRE(distance(at, s.place.point) == 0);
      REQUIRE((s.place.patch >= 0 && s.place.patch < 3));
    }
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, distance(corners[k], corners[(k + 1) % 3]));
      CHECK(nearest_sample_mm(field, corners[k]) < 1e-12 * (1 + longest));
    }
    CHECK(area == Approx(facet.area_mm2()).epsilon(1e-5));
    const double height = 2 * facet.area_mm2() / longest;
    CHECK(double(field.samples.size()) <= (longest / kSpacing_mm + 4) * (height / kSpacing_mm + 2));
    for (int n = 0; n < 200; ++n) {
      double a = share(random), b = share(random);
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const auto p = corners[0] * (1 - a - b) + corners[1] * a + corners[2] * b;
      REQUIRE(nearest_sample_mm(field, p) <= kSpacing_mm);
    }
  }
}

TEST_CASE("grids of facets take three patches each, and their quads face outward",
          "[unit][field]") {
  const ReferenceSurface block(tests::box_mesh({0, 0, 0}, {4, 2, 1}));
  const DeviationField field = sample_surface(block, 0.7);
  REQUIRE(field.grids.size() == 12);
  std::size_t samples = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const DeviationField::Grid& grid = field.grids[i];
    CHECK(grid.patch == int(3 * i));
    CHECK(grid.patches == 3);
    CHECK(grid.first == samples);
    for (const std::size_t end = samples + std::size_t(grid.columns) * grid.rows; samples < end;
         ++samples)
      REQUIRE(field.samples.at(samples).place.patch / 3 == int(i));
  }
  CHECK(samples == field.samples.size());
  for (const auto& quad : field.quads) {
    const auto p = [&](int k) { return field.samples[quad[k]].place.point; };
    REQUIRE(dot(cross(p(2) - p(0), p(3) - p(1)), field.samples[quad[0]].normal) >= 0);
  }
}
