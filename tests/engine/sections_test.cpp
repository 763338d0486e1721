#include "engine/surface/section/sections.h"

#include <cmath>

#include "tests/engine/cages.h"
#include "tests/engine/plane_crossing.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/feature_cages.h"

using namespace limitgauge;
using namespace engine::surface;

namespace {

/// Values between the extremes of a box along an axis, some of them coordinates of its middle.
std::vector<double> values_over(const model::Box3& box, int axis, int count) {
  std::vector<double> values;
  for (int k = 1; k < count; ++k)
    values.push_back(box.low[axis] + (box.high[axis] - box.low[axis]) * k / count);
  return values;
}

double length_of(const SectionCurve& curve) {
  double sum = curve.closed ? distance(curve.points.back(), curve.points.front()) : 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    sum += distance(curve.points[i - 1], curve.points[i]);
  return sum;
}

double longest_step(const SectionCurve& curve) {
  double longest = curve.closed ? distance(curve.points.back(), curve.points.front()) : 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    longest = std::max(longest, distance(curve.points[i - 1], curve.points[i]));
  return longest;
}

/// Brute force: all triangles of all patches.
double crossed_length(const OffsetModel& mesh, const AxisPlane& plane) {
  double sum = 0;
  for (const Grid& grid : mesh.grids) sum += test::crossed(grid, plane).length;
  return sum;
}

double longest_edge(const OffsetModel& mesh) {
  double longest = 0;
  for (const Grid& grid : mesh.grids)
    for (int v = 0; v + 1 < grid.rows; ++v)
      for (int u = 0; u + 1 < grid.columns; ++u)
        longest = std::max({longest, distance(grid.at(u, v), grid.at(u + 1, v + 1)),
                            distance(grid.at(u, v), grid.at(u + 1, v)),
                            distance(grid.at(u, v), grid.at(u, v + 1))});
  return longest;
}

/// Points of the open boundary and of borders of holes.
std::vector<Vec3> boundary_points(const PatchModel& model, const OffsetModel& mesh) {
  std::vector<Vec3> points;
  for (Index h = 0; h < model.outer().half_edge_count(); ++h) {
    if (!model.has_patch(h) || !model.ends_at(h)) continue;
    const Grid& grid = mesh.grids[model.patch_at(h)];
    for (int t = 0; t < grid.columns; ++t)
      points.push_back(grid.points[side_index(model.side_at(h), t, grid.columns - 1)]);
  }
  return points;
}

double distance_to(const std::vector<Vec3>& points, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& q : points) least = std::min(least, distance(p, q));
  return least;
}

/// A tall narrow spike on a plate that is almost flat.
model::Cage spike_cage() {
  return test::grid_cage(
      12, 5, [](double x, double y) { return x == 1 && y == 1 ? 25.0 : 0.01 * (x * x + y * y); });
}

/// A closed ring of square section: rows of `n` quads round the Z axis.
model::Cage torus_cage(int n, double radius, double half) {
  model::Cage cage;
  const double across[4] = {-half, half, half, -half}, up[4] = {-half, -half, half, half};
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 4; ++k) {
      const double angle = 6.283185307179586 * i / n, r = radius + across[k];
      cage.vertices.push_back({r * std::cos(angle), r * std::sin(angle), up[k]});
    }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 4; ++k) {
      const int j = (i + 1) % n, l = (k + 1) % 4;
      const model::Index corners[] = {4 * i + k, 4 * j + k, 4 * j + l, 4 * i + l};
      cage.add_face(corners);
    }
  return cage;
}

void check_watertight(const PatchModel& model, const OffsetModel& mesh, int planes) {
  const std::vector<Vec3> boundary = boundary_points(model, mesh);
  const double edge = longest_edge(mesh);
  model::Box3 box;
  for (const Grid& grid : mesh.grids)
    for (const Vec3& p : grid.points) box.add(p);
  for (const int axis : {0, 1, 2}) {
    const auto values = values_over(box, axis, planes);
    const auto family = sections(model, mesh, axis, values, {});
    REQUIRE(family.size() == values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      INFO("axis " << axis << " at " << values[k]);
      double length = 0;
      for (const SectionCurve& curve : family[k]) {
        length += length_of(curve);
        // No gap: a step is a way through one triangle, closing steps too.
        CHECK(longest_step(curve) <= edge * (1 + 1e-9));
        if (boundary.empty()) CHECK(curve.closed);
        if (curve.closed) continue;
        // An open curve ends on the boundary: within half an edge of one of its points.
        CHECK(distance_to(boundary, curve.points.front()) <= edge);
        CHECK(distance_to(boundary, curve.points.back()) <= edge);
      }
      CHECK(length == Approx(crossed_length(mesh, {axis, values[k]})).margin(1e-9));
    }
  }
}

}  // namespace

TEST_CASE("sections of every kind of cage are watertight", "[slow][section]") {
  const std::vector<model::Cage> cages = tests::feature_cages();
  const std::size_t stride = static_cast<std::size_t>(tests::by_effort(4, 1));
  for (std::size_t i = 0; i < cages.size(); i += stride) {
    const model::Cage& cage = cages[i];
    INFO(cage.name);
    const PatchModel model(cage, {0.03, 0, 4}, {});
    check_watertight(model, sample_offset(model, 0, 0.05), 5);
  }
}

TEST_CASE("sections of closed surfaces close", "[property][section]") {
  const PatchModel cube(test::cube_cage(10), {0.01, 3, 8}, {});
  check_watertight(cube, sample_offset(cube, 0, 0.0025), 12);
  check_watertight(cube, sample_offset(cube, 3, 0.0025), 12);
  const PatchModel ring(torus_cage(8, 20, 5), {0.01, 3, 8}, {});
  check_watertight(ring, sample_offset(ring, 0, 0.0025), 12);
  check_watertight(ring, sample_offset(ring, 3, 0.0025), 12);
}

TEST_CASE("no cracks where depths differ by four", "[property][section]") {
  const PatchModel model(spike_cage(), {0.01, 0, 9}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  const auto [low, high] = std::minmax_element(mesh.depths.begin(), mesh.depths.end());
  REQUIRE(*high - *low >= 4);
  check_watertight(model, mesh, 24);
}

TEST_CASE("a ring round a torus cut through its middle is two circles", "[unit][section]") {
  const PatchModel model(torus_cage(8, 20, 5), {0.01, 0, 8}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  for (const int axis : {0, 1, 2}) {
    const auto curves = section(model, mesh, {axis, 0});
    REQUIRE(curves.size() == 2);
    CHECK((curves[0].closed && curves[1].closed));
  }
}

TEST_CASE("the circle of a bowl has the length of its closed form", "[unit][section]") {
  const double k = 0.01;
  const PatchModel model(test::paraboloid_cage(10, 10, k), {0.01, 0, 10}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  std::vector<double> values;
  for (int i = 1; i <= 15; ++i) values.push_back(i);
  const auto family = sections(model, mesh, 2, values, {});
  for (std::size_t i = 0; i < values.size(); ++i) {
    REQUIRE(family[i].size() == 1);
    CHECK(family[i][0].closed);
    // The mesh lies over the bowl by 0.0025 at most: the circle is smaller by 0.0025 / (2 k r).
    const double r = std::sqrt(values[i] / k), less = 0.0025 / (2 * k * r);
    CHECK(length_of(family[i][0]) <= 6.283185307179586 * r);
    CHECK(length_of(family[i][0]) >= 6.283185307179586 * (r - 1.1 * less));
  }
}

TEST_CASE("a plane at the peak of a dome leaves a point, above it nothing", "[unit][section]") {
  const PatchModel model(test::paraboloid_cage(8, 10, -0.01), {0.01, 0, 8}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.0025);
  double top = -1;
  for (const Grid& grid : mesh.grids)
    for (const Vec3& p : grid.points) top = std::max(top, p.z);
  CHECK(top == Approx(0).margin(1e-12));
  for (const SectionCurve& curve : section(model, mesh, {2, top})) {
    CHECK(curve.closed);
    CHECK(length_of(curve) < 1e-9);
  }
  CHECK(section(model, mesh, {2, std::nextafter(top, 1.0)}).empty());
}

TEST_CASE("a plane along creases of an offset leaves each side open", "[unit][section]") {
  // All edges sharp: six flat faces moved out by 3, which do not meet.
  const PatchModel model(tests::scaled(tests::sharp_cube(true), 10), {0.01, 3, 6}, {});
  const OffsetModel mesh = sample_offset(model, 3, 0.0025);
  const auto curves = section(model, mesh, {2, 1.7});
  REQUIRE(curves.size() == 4);
  for (const SectionCurve& curve : curves) {
    CHECK(!curve.closed);
    CHECK(length_of(curve) == Approx(20).margin(1e-9));
  }
  const auto whole = section(model, sample_offset(model, 0, 0.0025), {2, 1.7});
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].closed);
  CHECK(length_of(whole[0]) == Approx(80).margin(1e-9));
}

TEST_CASE("a family of planes is the same for any number of threads", "[property][section]") {
  const PatchModel model(spike_cage(), {0.02, 0, 7}, {});
  const OffsetModel mesh = sample_offset(model, 0, 0.005);
  std::vector<double> values;
  for (int k = -40; k < 40; ++k) values.push_back(k * 0.7 + 0.1);
  model::RunControl three;
  three.threads = 3;
  const auto a = sections(model, mesh, 0, values, {}), b = sections(model, mesh, 0, values, three);
  for (std::size_t k = 0; k < values.size(); ++k) {
    REQUIRE(a[k].size() == b[k].size());
    const auto alone = section(model, mesh, {0, values[k]});
    REQUIRE(a[k].size() == alone.size());
    for (std::size_t c = 0; c < a[k].size(); ++c) {
      CHECK(a[k][c].points == b[k][c].points);
      CHECK(a[k][c].points == alone[c].points);
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
