#include "verifier/stock/mesh_outside.h"

#include <random>

#include "tests/support/catch.h"
#include "tests/support/solid_meshes.h"

namespace limitgauge::verifier {
namespace {

using model::TriangleMesh;
using model::Vec3;
using namespace tests;

/// Signed distance to a box, positive inside.
double box_distance(const Vec3& low, const Vec3& high, const Vec3& p) {
  double inside = 1e300;
  Vec3 beyond;
  for (int k = 0; k < 3; ++k) {
    inside = std::min({inside, p[k] - low[k], high[k] - p[k]});
    beyond[k] = std::max({low[k] - p[k], 0.0, p[k] - high[k]});
  }
  return inside >= 0 ? inside : -length(beyond);
}

/// Distance by looking at every triangle, and the side by the solid angle of the whole mesh (van
/// Oosterom and Strackee 1983): both other ways than the code under test.
double plain_distance(const TriangleMesh& mesh, const Vec3& p) {
  double nearest = 1e300, angle = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p,
               c = mesh.vertices[t[2]] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    const Vec3 n = normalized(cross(b - a, c - a));
    const Vec3 foot = n * dot(n, a);
    const bool in = dot(cross(b - a, foot - a), n) >= 0 && dot(cross(c - b, foot - b), n) >= 0 &&
                    dot(cross(a - c, foot - c), n) >= 0;
    double d = in ? std::abs(dot(n, a)) : 1e300;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      const Vec3 way = to - from;
      const double s = std::clamp(-dot(from, way) / dot(way, way), 0.0, 1.0);
      d = std::min(d, length(from + way * s));
    }
    nearest = std::min(nearest, d);
  }
  return angle > 2 * std::numbers::pi ? nearest : -nearest;
}

TriangleMesh wavy_block(int n) {
  return block_under(8, n, -5,
                     [](double x, double y) { return std::sin(0.7 * x) * std::cos(0.5 * y); });
}

struct Dice {
  std::mt19937 engine{20240611};
  double between(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  }
  Vec3 point(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
};

/// A cell of the kind that S is cut into: about `size` wide, bent by up to `bend`. Every other one
/// is level, as most faces of the meshes are.
Bezier random_cell(Dice& dice, const Vec3& at, double size, double bend) {
  const bool level = dice.engine() % 2 == 0;
  const Vec3 u = level ? Vec3{size, 0, 0} : normalized(dice.point(1)) * size;
  const Vec3 v = level ? Vec3{0, size, 0} : normalized(dice.point(1)) * size;
  Bezier cell;
  for (int k = 0; k < 16; ++k)
    cell.set(k, at + u * (k % 4 / 3.0 - 0.5) + v * (k / 4 / 3.0 - 0.5) + dice.point(bend));
  return cell;
}

}  // namespace

TEST_CASE("the distance to a mesh of a box is the box's", "[unit]") {
  const Vec3 low{-3, -2, -1}, size{6, 5, 4};
  const MeshOutside mesh(box_mesh(low, size));
  Dice dice;
  for (int n = 0; n < 20'000; ++n) {
    const Vec3 p = dice.point(7);
    const BodyDistance d = mesh.distance(p);
    const double truth = box_distance(low, low + size, p);
    REQUIRE(d.value == Approx(truth).margin(1e-12));
    // Straight up the gradient the distance grows as fast as one goes.
    const Vec3 further = p + d.gradient * 1e-3;
    if (truth < -1e-3) REQUIRE(mesh.distance(further).value == Approx(truth + 1e-3).margin(1e-9));
  }
}

TEST_CASE("the vertical through edges and vertices finds the right side", "[unit]") {
  // All these points lie exactly above or below vertices, edges and diagonals of the faces.
  const MeshOutside box(box_mesh({-2, -2, -2}, {4, 4, 4}));
  for (double x = -3; x <= 3; ++x)
    for (double y = -3; y <= 3; ++y)
      for (double z = -3; z <= 3; ++z) {
        const Vec3 p{x, y, z};
        CAPTURE(x, y, z);
        REQUIRE(box.distance(p).value ==
                Approx(box_distance({-2, -2, -2}, {2, 2, 2}, p)).margin(1e-12));
      }
  const TriangleMesh grid = wavy_block(16);
  const MeshOutside wavy(grid);
  for (const Vec3& v : grid.vertices)
    for (const double up : {-12.0, -0.125, 0.125, 12.0}) {
      const Vec3 p = v + Vec3{0, 0, up};
      REQUIRE(wavy.distance(p).value == Approx(plain_distance(grid, p)).margin(1e-9));
    }
}

TEST_CASE("the distance to a mesh agrees with a look at every triangle", "[property]") {
  // Two blocks that touch along an edge, one with a cavity; and a bent surface.
  const TriangleMesh touching =
      joined(joined(box_mesh({0, 0, 0}, {3, 3, 3}), box_mesh({3, 3, 0}, {2, 2, 2})),
             inside_out(box_mesh({1, 1, 1}, {1, 1, 1})));
  Dice dice;
  for (const TriangleMesh& solid : {touching, wavy_block(12), prism_mesh({1, 1, -2}, 4, 5, 40)}) {
    const MeshOutside mesh(solid);
    for (int n = 0; n < 4000; ++n) {
      const Vec3 p = dice.point(9);
      const double truth = plain_distance(solid, p);
      REQUIRE(mesh.distance(p).value == Approx(truth).margin(1e-11));
      const double limit = dice.between(-1, 3);
      if (std::abs(truth - limit) < 1e-9) continue;
      const auto near = mesh.distance_up_to(p, limit);
      REQUIRE(near.has_value() == (truth < limit));
      if (near) REQUIRE(near->value == Approx(truth).margin(1e-11));
    }
  }
}

TEST_CASE("a ray stays on its side of a mesh up to where it comes near, and no shorter",
          "[property]") {
  Dice dice;
  int met = 0, passed = 0, along_faces = 0;
  for (const TriangleMesh& solid :
       {box_mesh({-3, -3, -3}, {6, 6, 6}), wavy_block(12), prism_mesh({1, 1, -2}, 4, 5, 40)}) {
    const MeshOutside mesh(solid);
    for (int n = 0; n < 600; ++n) {
      Vec3 p = dice.point(9), ray = normalized(dice.point(1));
      // Beside a face and along it too, which it stays beside for long.
      if (n % 3 == 0) p.x = 3 + dice.between(0, 1e-3), ray = normalized(Vec3{1e-4, ray.y, ray.z});
      const double within = n % 2 == 0 ? 5e-7 : 0.05, limit = dice.between(1, 20);
      const double start = std::abs(mesh.distance(p).value);
      const double t = mesh.same_side_up_to(p, ray, limit, within);
      REQUIRE(t >= 0);
      REQUIRE(t <= limit);
      if (start <= within) {
        CHECK(t == 0);
        continue;
      }
      const bool inside = mesh.distance(p).value > 0;
      for (int k = 0; k < 200; ++k) {
        const BodyDistance d = mesh.distance(p + ray * (t * k / 200));
        CHECK((d.value > 0) == inside);
        CHECK(std::abs(d.value) > within - 1e-9);
      }
      along_faces += n % 3 == 0 && t > 100 * start;
      t < limit ? ++met : ++passed;
      if (t < limit) CHECK(std::abs(mesh.distance(p + ray * t).value) <= within + 1e-9);
    }
  }
  CHECK(met > 300);
  CHECK(passed > 300);
  CHECK(along_faces > 5);
}

TEST_CASE("no point of a cell is beyond the bounds of its distance to a mesh", "[slow]") {
  Dice dice;
  for (const TriangleMesh& solid :
       {box_mesh({-6, -6, -3}, {12, 12, 3}), box_mesh({-6, -6, -0.05}, {12, 12, 0.05}),
        wavy_block(10), wavy_block(60),
        joined(box_mesh({-6, -6, -6}, {12, 12, 6}),
               inside_out(box_mesh({-2, -2, -3}, {4, 4, 2})))}) {
    const MeshOutside mesh(solid);
    for (int n = 0; n < 3000; ++n) {
      // Most of them near the mesh, where the two sides meet.
      const std::size_t k = dice.engine() % solid.triangles.size();
      const auto& t = solid.triangles[k];
      const Vec3 on = lerp(lerp(solid.vertices[t[0]], solid.vertices[t[1]], dice.between(0, 1)),
                           solid.vertices[t[2]], dice.between(0, 1));
      const double size = std::pow(10, dice.between(-3, 0.3));
      const Bezier cell =
          random_cell(dice, on + dice.point(2 * size), size, size * dice.between(0, 0.2));
      const Vec3 m = middle(cell);
      const BodyDistance d = mesh.distance(m);
      const double low = mesh.lower(cell, m, d), high = mesh.upper(cell, m, d);
      std::array<double, 16> majorant{};
      mesh.values(cell, majorant);
      const double most = *std::max_element(majorant.begin(), majorant.end());
      for (int i = 0; i <= 6; ++i)
        for (int j = 0; j <= 6; ++j) {
          const double here = mesh.distance(point(cell, i / 6.0, j / 6.0)).value;
          REQUIRE(here >= low - 1e-11);
          REQUIRE(here <= high + 1e-11);
          REQUIRE(here <= most + 1e-11);
        }
    }
  }
}

TEST_CASE("beyond a mesh every distance and bound is more by that", "[unit]") {
  const double more = 0.3;
  const MeshOutside plain(wavy_block(12)), grown = plain.beyond(more);
  Dice dice;
  const auto place = [&] {
    return Vec3{dice.between(-9, 9), dice.between(-9, 9), dice.between(-6, 3)};
  };
  for (int n = 0; n < 300; ++n) {
    const Vec3 p = place();
    const double d = grown.distance(p).value;
    CHECK(d == Approx(plain.distance(p).value + more).margin(1e-12));
    for (const double limit : {d - 1e-6, d + 1e-6, -0.1, 0.2})
      CHECK(grown.distance_up_to(p, limit).has_value() == (d <= limit));
    Bezier cell;
    const Vec3 u{dice.between(-0.3, 0.3), dice.between(-0.3, 0.3), dice.between(-0.3, 0.3)},
        v{dice.between(-0.3, 0.3), dice.between(-0.3, 0.3), dice.between(-0.3, 0.3)};
    for (int k = 0; k < 16; ++k) cell.set(k, p + u * (k % 4) + v * (k / 4));
    const Vec3 m = middle(cell);
    const BodyDistance at = grown.distance(m);
    const double low = grown.lower(cell, m, at), high = grown.upper(cell, m, at);
    for (int k = 0; k <= 16; ++k) {
      const double here = plain.distance(point(cell, (k % 5) / 4.0, (k / 5) / 4.0)).value + more;
      CHECK(here >= low - 1e-9);
      CHECK(here <= high + 1e-9);
    }
  }
}

TEST_CASE("over a face of a mesh the bounds close at once, over a bend to second order", "[unit]") {
  // Flat squares a tenth of the cell wide: as over one large face, on either side of it and in it.
  const MeshOutside flat(block_under(8, 160, -5, [](double, double) { return 0.0; }));
  const auto level = [](double z, double size) {
    Bezier cell;
    for (int k = 0; k < 16; ++k)
      cell.set(k, {0.13 + size * (k % 4) / 3.0, -0.2 + size * (k / 4) / 3.0, z});
    return cell;
  };
  for (const double z : {-0.5, -0.02, -1e-5, 0.0, 1e-5, 0.02, 0.5}) {
    const Bezier cell = level(z, 1);
    const Vec3 m = middle(cell);
    const BodyDistance d = flat.distance(m);
    CAPTURE(z);
    CHECK(flat.lower(cell, m, d) == Approx(-z).margin(1e-10));
    if (z > -0.1) CHECK(flat.upper(cell, m, d) == Approx(-z).margin(1e-10));
  }
  // A bar of 20 mm with 4000 sides of 0.016 mm, and cells that touch it from within: the sagitta of
  // a cell of 2·h is h²/20.
  const MeshOutside bar(prism_mesh({0, 0, -5}, 10, 10, 4000));
  for (const double h : {0.2, 0.1, 0.05}) {
    Bezier cell;
    for (int k = 0; k < 16; ++k) cell.set(k, {9.999, h * (k % 4 / 1.5 - 1), h * (k / 4 / 1.5 - 1)});
    const Vec3 m = middle(cell);
    const BodyDistance d = bar.distance(m);
    CAPTURE(h);
    CHECK(d.value == Approx(0.001).margin(1e-5));
    CHECK(bar.lower(cell, m, d) > 0.001 - 4 * h * h / 20);
    CHECK(bar.upper(cell, m, d) < 0.001 + 4 * h * h / 20);
  }
}

TEST_CASE("triangles without area, and none at all", "[unit]") {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
  // The middle of an edge is a vertex of one face only; a triangle without area closes the mesh.
  mesh.vertices.push_back({1, 0, 0});
  REQUIRE(mesh.triangles[4] == std::array<std::uint32_t, 3>{0, 1, 5});
  mesh.triangles[4] = {0, 8, 5};
  mesh.triangles.push_back({8, 1, 5});
  mesh.triangles.push_back({0, 1, 8});
  const MeshOutside outside(mesh);
  CHECK(outside.distance({1, -1, -1}).value == Approx(-std::sqrt(2.0)));
  CHECK(outside.distance({1, 0.5, 0.75}).value == Approx(0.5));
  CHECK_THROWS_AS(MeshOutside(TriangleMesh{}), std::invalid_argument);
  mesh.triangles.push_back({0, 1, 99});
  CHECK_THROWS_AS(MeshOutside(mesh), std::invalid_argument);
}

}  // namespace limitgauge::verifier
