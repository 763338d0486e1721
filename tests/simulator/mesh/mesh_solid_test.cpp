#include "simulator/mesh/mesh_solid.h"

#include <cmath>
#include <numbers>
#include <random>

#include "simulator/mesh/mesh_tree.h"
#include "simulator/stock/raw_stock.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"

using namespace limitgauge::simulator;
using namespace limitgauge::tests;
using limitgauge::model::BoxStock;
using limitgauge::model::distance;
using limitgauge::model::length;
using limitgauge::model::MeshStock;
using limitgauge::model::TriangleMesh;
using limitgauge::model::Vec3;

namespace {

MeshSolid solid_of(TriangleMesh mesh) {
  return MeshSolid(std::make_shared<const TriangleMesh>(std::move(mesh)));
}

class Points {
 public:
  explicit Points(unsigned seed) : random_(seed) {}
  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 in_cube(double half) {
    return {within(-half, half), within(-half, half), within(-half, half)};
  }
  /// On a lattice, where the meshes' own coordinates lie too.
  Vec3 on_lattice(double half, double step) {
    Vec3 p = in_cube(half);
    for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] / step) * step;
    return p;
  }

 private:
  std::mt19937 random_;
};

// The box's own distance: what the mesh of twelve triangles must give.
double box_distance(const Vec3& half, const Vec3& p) {
  Vec3 over;
  double most = -1e9;
  for (int a = 0; a < 3; ++a) {
    const double d = std::abs(p[a]) - half[a];
    over[a] = std::max(d, 0.0), most = std::max(most, d);
  }
  return most > 0 ? length(over) : most;
}

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double whole = length_squared(ab);
  return whole > 0 ? a + ab * std::clamp(dot(ab, p - a) / whole, 0.0, 1.0) : a;
}

// The foot on the triangle's plane where that is in the triangle, and else the nearest of the
// edges. Not for slivers.
double distance_to_triangle(const MeshTree::Triangle& t, const Vec3& p) {
  const Vec3 normal = normalized(cross(t[1] - t[0], t[2] - t[0]));
  double edges = 1e300;
  bool over = true;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[(k + 1) % 3];
    edges = std::min(edges, distance(p, nearest_on_segment(a, b, p)));
    over = over && dot(cross(normal, b - a), p - a) >= 0;
  }
  return over ? std::abs(dot(normal, p - t[0])) : edges;
}

// Least distance to all triangles, each asked in turn.
double nearest_of_all(const TriangleMesh& mesh, const Vec3& p) {
  double best = 1e300;
  for (const auto& t : mesh.triangles)
    best = std::min(best, distance_to_triangle(
                              {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, p));
  return best;
}

// Sum of the solid angles of all triangles over 4 π: 1 inside, 0 outside (A. van Oosterom and
// J. Strackee, 1983). Another way to the sign than the vertical.
double solid_angle_winding(const TriangleMesh& mesh, const Vec3& p) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p,
               c = mesh.vertices[t[2]] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)),
                          la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace

TEST_CASE("the mesh of a block has the block's distance", "[property][mesh]") {
  const Vec3 half{4, 3, 2};
  const MeshSolid solid = solid_of(block_between(-half, half));
  Points points(1);
  for (int n = 0; n < 20000; ++n) {
    // Lattice points lie in faces and over edges and vertices.
    const Vec3 p = n % 2 == 0 ? points.in_cube(6) : points.on_lattice(6, 0.5);
    const double want = box_distance(half, p);
    const SolidSample s = solid.sample(p);
    // Lengths of about ten with a few roundings.
    REQUIRE(s.distance == Approx(want).margin(1e-14));
    REQUIRE(length(s.gradient) == Approx(1).epsilon(1e-12));
    if (std::abs(want) > 1e-12) REQUIRE((s.distance < 0) == (want < 0));
    // A step along the gradient changes the distance by as much.
    if (want > 0.01) REQUIRE(box_distance(half, p + s.gradient * 0.01) == Approx(want + 0.01));
  }
  CHECK(solid.volume_mm3() == Approx(8 * 4 * 3 * 2).epsilon(1e-14));
  CHECK(solid.area_mm2() == Approx(8 * (4 * 3 + 3 * 2 + 2 * 4)).epsilon(1e-14));
}

TEST_CASE("a fine sphere has nearly the sphere's distance", "[property][mesh]") {
  const double radius = 10;
  const Vec3 centre{1, 2, 3};
  const MeshSolid solid = solid_of(sphere_mesh(centre, radius, 60, 120));
  // The inscribed facets lie within r (1 - cos(π/60)) of the sphere across a sector, and as much
  // again along a band.
  const double sagitta = 2 * radius * (1 - std::cos(std::numbers::pi / 60));
  Points points(2);
  for (int n = 0; n < 20000; ++n) {
    const Vec3 p = centre + points.in_cube(15);
    const double want = distance(p, centre) - radius, got = solid.sample(p).distance;
    REQUIRE(got >= want - 1e-12);
    REQUIRE(got <= want + sagitta);
  }
}

TEST_CASE("distance and side against brute force", "[property][mesh]") {
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 5, 9, 14);
  append_mesh(mesh, inside_out(sphere_mesh({0.5, 0, 0}, 3, 7, 8)));
  append_mesh(mesh, block_between({6, -2, -2}, {9, 2, 2}));
  const MeshSolid solid = solid_of(mesh);
  Points points(3);
  int inside = 0;
  for (int n = 0; n < 5000; ++n) {
    const Vec3 p = points.in_cube(10);
    const double d = nearest_of_all(mesh, p), winding = solid_angle_winding(mesh, p);
    REQUIRE(std::abs(solid.sample(p).distance) == Approx(d).margin(1e-14));
    // The angles sum to whole numbers but for rounding where p is off the surface.
    if (d > 1e-6) REQUIRE(solid.contains(p) == (winding > 0.5));
    inside += winding > 0.5;
  }
  CHECK(inside > 200);
}

TEST_CASE("verticals through edges and vertices", "[property][mesh]") {
  // A ball on a lattice: its vertices have round coordinates, and so have all points.
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 4, 12, 16);
  for (Vec3& v : mesh.vertices)
    for (int a = 0; a < 3; ++a) v[a] = std::round(v[a] * 4) / 4;
  const MeshSolid solid = solid_of(mesh);
  int looked_at = 0;
  for (double x = -5; x <= 5; x += 0.25)
    for (double y = -5; y <= 5; y += 0.25) {
      const std::vector<double> heights = solid.crossings(x, y);
      REQUIRE(heights.size() % 2 == 0);
      REQUIRE(std::is_sorted(heights.begin(), heights.end()));
      for (double z = -5; z <= 5; z += 0.25) {
        if (nearest_of_all(mesh, {x, y, z}) < 1e-9) continue;
        ++looked_at;
        const bool inside = solid_angle_winding(mesh, {x, y, z}) > 0.5;
        REQUIRE(solid.contains({x, y, z}) == inside);
        bool by_heights = false;
        for (const double h : heights) by_heights ^= h <= z;
        REQUIRE(by_heights == inside);
      }
    }
  CHECK(looked_at > 60000);
}

TEST_CASE("slanted lattice solids seen straight along their edges", "[property][mesh]") {
  // Every vertical of the lattice passes through edges that are not exactly representable lines.
  TriangleMesh mesh = block_between({-3, -3, -3}, {3, 3, 3});
  for (Vec3& v : mesh.vertices) v = {v.x + 0.1 * v.z, v.y + 0.3 * v.x - 0.1 * v.z, v.z + 0.7 * v.y};
  const MeshSolid solid = solid_of(mesh);
  Points points(4);
  for (int n = 0; n < 20000; ++n) {
    // Points over the edges: on the line between two vertices, as far as doubles allow.
    const auto& t = mesh.triangles[n % mesh.triangles.size()];
    const Vec3 &a = mesh.vertices[t[n % 3]], &b = mesh.vertices[t[(n + 1) % 3]];
    const Vec3 over = lerp(a, b, std::round(points.within(0, 10)) / 10);
    const Vec3 p{over.x, over.y, points.within(-7, 7)};
    if (nearest_of_all(mesh, p) < 1e-6) continue;
    REQUIRE(solid.contains(p) == (solid_angle_winding(mesh, p) > 0.5));
    REQUIRE(solid.crossings(p.x, p.y).size() % 2 == 0);
  }
}

TEST_CASE("solids that touch or overlap themselves", "[unit][mesh]") {
  SECTION("along an edge") {
    TriangleMesh mesh = block_between({0, 0, 0}, {1, 1, 1});
    append_mesh(mesh, block_between({1, 1, 0}, {2, 2, 1}));
    const MeshSolid solid = solid_of(mesh);
    CHECK(solid.sample({0.75, 0.75, 0.5}).distance == Approx(-0.25));
    CHECK(solid.sample({1.25, 1.25, 0.5}).distance == Approx(-0.25));
    CHECK(solid.sample({1.25, 0.75, 0.5}).distance == Approx(0.25));
    CHECK(solid.sample({0.75, 1.25, 0.5}).distance == Approx(0.25));
    CHECK(std::abs(solid.sample({1, 1, 0.5}).distance) == 0);
    CHECK(solid.crossings(1, 1) == std::vector<double>{0, 1});
    CHECK(solid.crossings(1, 0.5).empty());
  }
  SECTION("in a face: one solid, without a gap between") {
    TriangleMesh mesh = block_between({0, 0, 0}, {1, 1, 1});
    append_mesh(mesh, block_between({0, 0, 1}, {1, 1, 2}));
    const MeshSolid solid = solid_of(mesh);
    CHECK(solid.crossings(0.5, 0.5) == std::vector<double>{0, 2});
    CHECK(solid.contains({0.5, 0.5, 1}));
  }
  SECTION("overlapping") {
    TriangleMesh mesh = block_between({0, 0, 0}, {2, 2, 2});
    append_mesh(mesh, block_between({1, 1, 1}, {3, 3, 3}));
    const MeshSolid solid = solid_of(mesh);
    CHECK(solid.crossings(1.5, 1.5) == std::vector<double>{0, 3});
    CHECK(solid.contains({1.5, 1.5, 1.5}));
    CHECK_FALSE(solid.contains({0.5, 0.5, 2.5}));
  }
  SECTION("nested shells") {
    const MeshSolid solid = solid_of(hollow_block(2, 1));
    CHECK(solid.crossings(0, 0) == std::vector<double>{-2, -1, 1, 2});
    CHECK(solid.sample({0, 0, 0}).distance == Approx(1));
    CHECK(solid.sample({0, 0, 1.5}).distance == Approx(-0.5));
    CHECK(solid.sample({0, 0, 1.25}).gradient == Vec3{0, 0, -1});
    CHECK(solid.volume_mm3() == Approx(64 - 8));
    CHECK(solid.area_mm2() == Approx(6 * 16 + 6 * 4));
  }
}

/// The least distance from p to segments from a to places on bc, which are all of the triangle: no
/// plane is needed. On slivers segments are all but parallel, and no step is too coarse.
double by_segments(const MeshTree::Triangle& t, const Vec3& p) {
  double best = distance(p, t[0]), at = 0.5;
  for (double reach = 0.5; reach > 1e-9; reach /= 16) {
    const double middle = at;
    for (int k = -32; k <= 32; ++k) {
      const double u = std::clamp(middle + reach * k / 32, 0.0, 1.0);
      const double d = distance(p, nearest_on_segment(t[0], lerp(t[1], t[2], u), p));
      if (d < best) best = d, at = u;
    }
  }
  return best;
}

TEST_CASE("slivers have exact distances", "[property][mesh]") {
  // Triangles 10 mm long and of all widths down to less than a rounding, somewhere on the machine's
  // table, each corner first: rounding must not move the nearest point.
  Points points(6);
  for (int n = 0; n < 3000; ++n) {
    const double width = std::pow(10.0, points.within(-18, -1));
    const Vec3 a = points.in_cube(100), along = normalized(points.in_cube(1)),
               across = normalized(cross(along, points.in_cube(1)));
    const Vec3 b = a + along * 10, c = a + along * points.within(0, 10) + across * width;
    const Vec3 p = lerp(a, b, points.within(-0.2, 1.2)) + points.in_cube(2);
    const double edge = distance(p, nearest_on_segment(a, b, p));
    TriangleMesh mesh{{a, b, c}, {{0, 1, 2}}};
    std::rotate(mesh.triangles[0].begin(), mesh.triangles[0].begin() + n % 3,
                mesh.triangles[0].end());
    const double got = std::sqrt(MeshTree(mesh).nearest(p).distance_squared);
    // No further than to the edge ab, and by no more than the width nearer.
    REQUIRE(got <= edge + 1e-12);
    REQUIRE(got >= edge - width - 1e-12);
    if (width > 1e-4) REQUIRE(got == Approx(distance_to_triangle({a, b, c}, p)).margin(1e-11));
    REQUIRE(got == Approx(by_segments({a, b, c}, p)).margin(1e-12));
  }
}

namespace {

/// A block of 2 x 2 mm whose top rises along x, z = 2 + x, with a sliver along the top's diagonal:
/// the corner of +x and +y is there twice, the last bit of y (or of x) apart.
TriangleMesh slanted_block_with_sliver(bool apart_in_y) {
  const double less = std::nextafter(1.0, 0.0);
  const Vec3 twin = apart_in_y ? Vec3{1, less, 3} : Vec3{less, 1, 2 + less};
  TriangleMesh mesh;
  mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0},  {-1, 1, 0}, {-1, -1, 1},
                   {1, -1, 3},  {1, 1, 3},  {-1, 1, 1}, twin};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {0, 4, 7}, {0, 7, 3}};
  if (apart_in_y)
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{4, 5, 8}, {4, 8, 6}, {4, 6, 7}, {1, 2, 6}, {1, 6, 8}, {1, 8, 5}, {2, 3, 7}, {2, 7, 6}});
  else
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{4, 5, 6}, {4, 6, 8}, {4, 8, 7}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 8}, {2, 8, 6}});
  return mesh;
}

}  // namespace

TEST_CASE("a vertical along a sliver leaves the solid where the sliver is", "[unit][mesh]") {
  for (const bool apart_in_y : {true, false}) {
    const MeshSolid solid = solid_of(slanted_block_with_sliver(apart_in_y));
    for (const double at : {-0.9, -0.5, -0.3, 0.0, 0.1, 0.5, 0.7}) {
      CAPTURE(apart_in_y, at);
      const std::vector<double> heights = solid.crossings(at, at);
      REQUIRE(heights.size() == 2);
      CHECK(heights[0] == 0);
      CHECK(heights[1] == Approx(2 + at).margin(1e-12));
    }
  }
}

TEST_CASE("triangles without area bound nothing", "[unit][mesh]") {
  // A corner in the middle of an edge, a whisker and a triangle that is a point.
  TriangleMesh mesh = block_between({0, 0, 0}, {4, 4, 4});
  mesh.vertices.push_back({2, 0, 0}), mesh.vertices.push_back({8, 8, 8});
  mesh.triangles[1] = {0, 3, 8};
  mesh.triangles.insert(mesh.triangles.end(), {{8, 3, 1}, {0, 8, 1}, {7, 9, 7}, {5, 5, 5}});
  const MeshSolid solid = solid_of(mesh);
  CHECK(solid.sample({2, 2, 1}).distance == Approx(-1));
  CHECK(solid.sample({2, 2, -1}).distance == Approx(1));
  CHECK(solid.sample({5, 5, 5.5}).distance == Approx(std::sqrt(1.0 / 6)));
  CHECK_FALSE(solid.contains({6, 6, 6}));
  CHECK(solid.crossings(2, 0.5) == std::vector<double>{0, 4});
}

TEST_CASE("a place one unit in the last place off a wall", "[unit][mesh]") {
  // An upright wall from (12, 12) to (24, 24), whose plane passes through the point (0.1, 0.1) but
  // not through its neighbours; differences of these numbers are not exact.
  TriangleMesh mesh = block_between({-1, -1, -1}, {1, 1, 1});
  const std::array<Vec3, 4> below{Vec3{-24, -24, -1}, {24, 24, -1}, {-24, 24, -1}, {-12, 36, -1}};
  for (int k = 0; k < 4; ++k)
    mesh.vertices[k] = below[k], mesh.vertices[k + 4] = below[k] + Vec3{0, 0, 2};
  const MeshSolid solid = solid_of(mesh);
  const double up = std::nextafter(0.1, 1.0);
  CHECK(solid.contains({0.1, up, 0}));
  CHECK_FALSE(solid.contains({up, 0.1, 0}));
  CHECK(solid.crossings(0.1, up).size() == 2);
  CHECK(solid.crossings(up, 0.1).empty());
}

TEST_CASE("a column of distances is the distances of its points", "[property][mesh]") {
  const MeshSolid solid = solid_of(hollow_block(2, 1));
  Points points(7);
  std::vector<double> column(40);
  for (int n = 0; n < 300; ++n) {
    const Vec3 p = points.on_lattice(3, 0.125) - Vec3{0, 0, 1};
    solid.distances_up(p, 0.125, column);
    for (std::size_t k = 0; k < column.size(); ++k) {
      const Vec3 q{p.x, p.y, p.z + 0.125 * static_cast<double>(k)};
      REQUIRE(column[k] == solid.sample(q).distance);
      REQUIRE(std::signbit(column[k]) == std::signbit(solid.sample(q).distance));
    }
  }
}

TEST_CASE("meshes that bound no solid are refused", "[unit][mesh]") {
  TriangleMesh open = block_between({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  CHECK_THROWS_WITH(solid_of(open), ContainsSubstring("has one triangle only"));
  CHECK_THROWS_AS(MeshSolid(nullptr), std::invalid_argument);
}

TEST_CASE("raw stock as block and as the block's mesh", "[property][mesh][stock]") {
  const Vec3 low{-4, -3, -2}, high{4, 3, 2};
  const RawStock block(BoxStock{low, high - low});
  const RawStock mesh(
      MeshStock{std::make_shared<const TriangleMesh>(block_between(low, high)), "block.stl", 0});
  CHECK(block.convex());
  CHECK_FALSE(mesh.convex());
  CHECK(mesh.box().low == low);
  CHECK(mesh.box().high == high);
  CHECK(surface_area_mm2(mesh) == Approx(surface_area_mm2(block)).epsilon(1e-14));
  Points points(8);
  std::array<double, 8> one, other;
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = points.in_cube(6);
    REQUIRE(raw_distance(mesh, p).distance ==
            Approx(raw_distance(block, p).distance).margin(1e-14));
    block.distances_up(p, 0.25, one), mesh.distances_up(p, 0.25, other);
    for (int k = 0; k < 8; ++k) REQUIRE(other[k] == Approx(one[k]).margin(1e-14));
  }
}

TEST_CASE("a plane over a solid is nowhere under it within the reach", "[property][mesh]") {
  // Steps and inner corners; a block that overlaps another, whose inner triangles bound nothing.
  TriangleMesh steps = block_between({-4, -3, -2}, {4, 3, 0});
  append_mesh(steps, block_between({-1, -3.5, -1}, {4.5, 2, 2}));
  const MeshSolid solid = solid_of(steps);
  Points points(9);
  int found = 0;
  for (int n = 0; n < 20000; ++n) {
    const Vec3 p = points.in_cube(5);
    const double reach = points.within(0.01, 0.6);
    const auto cap = solid.cap(p, reach);
    if (!cap) continue;
    ++found;
    REQUIRE(length(cap->normal) == Approx(1).margin(1e-12));
    for (int k = 0; k < 20; ++k) {
      const Vec3 off = points.in_cube(reach / std::sqrt(3.0));
      REQUIRE(-solid.sample(p + off).distance <= cap->depth - dot(cap->normal, off) + 1e-9);
    }
  }
  CHECK(found > 500);
  // Flat, with both its triangles, at an outer edge, and not at the inner corner of the step.
  CHECK(solid.cap({-2.5, -1, 0.01}, 0.1));
  CHECK(solid.cap({-4, -1, -0.01}, 0.1));
  CHECK_FALSE(solid.cap({-1.01, 0, 0.01}, 0.1));
}
