#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "simulator/mesh/fixture_solid.h"
#include "simulator/process/tool_bodies.h"
#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using model::Box3;
using model::CutterType;
using model::TriangleMesh;
using model::Vec3;
using simulator::CutterProfile;
using simulator::Finding;
using simulator::FindingKind;
using simulator::FixtureSolid;
using simulator::ProcessLimits;
using simulator::SweptMove;

constexpr double kForEver = std::numeric_limits<double>::infinity();

ProcessLimits with_fixture(const TriangleMesh& mesh, double near_miss_mm = 0) {
  ProcessLimits limits = plain_limits(near_miss_mm);
  limits.fixtures = {fixture("clamp", mesh)};
  return limits;
}

std::vector<Finding> check_in_air(const simulator::Pass& pass, const ProcessLimits& limits) {
  static const simulator::StockModel far{model::BoxStock{{-15, -10, -80}, {30, 20, 8}}, 1,
                                         std::size_t{1} << 30};
  return check(far, pass, limits);
}

FixtureSolid solid(const TriangleMesh& mesh) {
  return FixtureSolid(std::make_shared<const TriangleMesh>(mesh));
}

// Inside means an odd number of crossings, counted along a slanted ray by Cramer's rule.
bool brute_inside(const TriangleMesh& mesh, const Vec3& p) {
  const Vec3 ray{0.3127, 0.2311, 1};
  int crossings = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], u = mesh.vertices[t[1]] - a, v = mesh.vertices[t[2]] - a;
    const double det = dot(cross(ray, v), u);
    const Vec3 w = p - a;
    const double s = dot(cross(ray, v), w) / det, r = dot(cross(w, u), ray) / det,
                 along = dot(cross(w, u), v) / det;
    if (s >= 0 && r >= 0 && s + r <= 1 && along > 0) ++crossings;
  }
  return crossings % 2 == 1;
}

// Least distance over a triangle: a grid of samples, then finer ones about the best.
double sampled_least(const CutterProfile& body, const SweptMove& move, const Vec3& a, const Vec3& b,
                     const Vec3& c) {
  double best = kForEver, u0 = 0, v0 = 0, reach = 1;
  for (int round = 0; round < 12; ++round) {
    const double uc = u0, vc = v0;
    constexpr int kSamples = 24;
    for (int i = -kSamples; i <= kSamples; ++i)
      for (int j = -kSamples; j <= kSamples; ++j) {
        const double u = std::clamp(uc + reach * i / kSamples, 0.0, 1.0);
        const double v = std::clamp(vc + reach * j / kSamples, 0.0, 1.0 - u);
        const double d = swept_distance(body, move, a + (b - a) * u + (c - a) * v).distance;
        if (d < best) best = d, u0 = u, v0 = v;
      }
    reach *= 0.4;
  }
  return best;
}

}  // namespace

TEST_CASE("a body meets a fixture at a known depth", "[unit][fixture]") {
  // A clamp whose top is 2 mm below the top of the world, its side at x = 5.
  const TriangleMesh clamp = box_mesh({{5, -30, -20}, {40, 30, 10}});
  auto c = flat4(6);
  c.shank = {{4, 4}};
  c.holder = {{20, 30}};
  const auto pass = [&](double x, double z) {
    return PathBuilder({-30, 0, z}).rapid({x, 0, z}).feed({x, 3, z}).pass(c);
  };
  // Flutes and shank 2 mm from the side at x = 1; the holder, 10 mm wide, starts 10 mm above.
  CHECK(check_in_air(pass(1, 0.02), with_fixture(clamp)).empty());
  const auto flutes = check_in_air(pass(3.5, 0.02), with_fixture(clamp));
  REQUIRE(flutes.size() == 4);  // cutter and shank on both moves
  CHECK(flutes[0].kind == FindingKind::fixture_touched);
  CHECK(flutes[0].part == "cutter");
  CHECK(flutes[0].against == "clamp");
  CHECK(flutes[0].depth_mm == Approx(0.5).margin(kTolerance / 8));
  CHECK(flutes[0].point.x == Approx(5).margin(1e-9));
  CHECK(flutes[1].part == "shank");
  const auto holder = check_in_air(pass(0, -0.3), with_fixture(clamp));
  REQUIRE(holder.size() == 2);
  CHECK(holder[0].part == "holder");
  CHECK(holder[0].depth_mm == Approx(0.3).margin(kTolerance / 8));
  CHECK(holder[1].line == 2);
}

TEST_CASE("sliding along a fixture within the tolerance fails nothing", "[unit][fixture]") {
  const TriangleMesh table = box_mesh({{-50, -50, -20}, {50, 50, 0}});
  const auto pass = [](double z) {
    return PathBuilder({-30, 0, 20}).rapid({-30, 0, z}).feed({30, 7, z}).pass(flat4());
  };
  CHECK(check_in_air(pass(0), with_fixture(table)).empty());
  CHECK(check_in_air(pass(-0.09 * kTolerance), with_fixture(table)).empty());
  const auto slight = check_in_air(pass(-0.9 * kTolerance), with_fixture(table));
  REQUIRE(slight.size() == 2);
  for (const Finding& f : slight) CHECK(f.kind == FindingKind::slight_contact);
  const auto all = check_in_air(pass(-2 * kTolerance), with_fixture(table));
  REQUIRE(all.size() == 2);
  CHECK(all[1].depth_mm == Approx(2 * kTolerance).margin(1e-9));
}

TEST_CASE("a body wholly inside a fixture and a fixture inside a body", "[unit][fixture]") {
  const TriangleMesh big = box_mesh({{-40, -40, -40}, {40, 40, 40}});
  const auto inside =
      check_in_air(PathBuilder({0, 0, 0}).feed({10, 0, 0}).pass(flat4()), with_fixture(big));
  REQUIRE(inside.size() == 1);
  CHECK(inside[0].kind == FindingKind::fixture_touched);
  // The top, at z = 20, is 20 mm from the wall; the middle is 2 mm deep in the cutter.
  CHECK(inside[0].depth_mm == Approx(22).margin(kTolerance));
  const TriangleMesh pin = box_mesh({{-0.5, -0.5, 5}, {0.5, 0.5, 6}});
  const auto swallowed =
      check_in_air(PathBuilder({-1, 0, 0}).feed({1, 0, 0}).pass(flat4()), with_fixture(pin));
  REQUIRE(swallowed.size() == 1);
  // Its middle passes through the axis.
  CHECK(swallowed[0].depth_mm == Approx(2).margin(kTolerance));
  // The mouth of a U: inside its box and inside none of its material.
  TriangleMesh vice = box_mesh({{-20, -20, -10}, {20, -10, 10}});
  const TriangleMesh jaw = box_mesh({{-20, 10, -10}, {20, 20, 10}});
  for (auto t : jaw.triangles) {
    for (auto& v : t) v += 8;
    vice.triangles.push_back(t);
  }
  vice.vertices.insert(vice.vertices.end(), jaw.vertices.begin(), jaw.vertices.end());
  CHECK(check_in_air(PathBuilder({-5, 0, 0}).feed({5, 0, 0}).pass(flat4()), with_fixture(vice))
            .empty());
}

TEST_CASE("near misses of fixtures have the distance that is left", "[unit][fixture]") {
  const TriangleMesh clamp = box_mesh({{5, -30, -20}, {40, 30, 10}});
  const auto pass = [](double x) { return PathBuilder({-30, 0, 0}).feed({x, 0, 0}).pass(flat4()); };
  CHECK(check_in_air(pass(2.4), with_fixture(clamp, 0.5)).empty());
  for (const double left : {0.4, 0.05, 0.0}) {
    const auto all = check_in_air(pass(3 - left), with_fixture(clamp, 0.5));
    REQUIRE(all.size() == 1);
    CHECK(all[0].kind == FindingKind::near_miss);
    CHECK(all[0].part == "cutter");
    CHECK(all[0].against == "clamp");
    CHECK(all[0].depth_mm == Approx(-left).margin(kTolerance / 8));
    CHECK(all[0].point.x == Approx(5).margin(1e-9));
  }
  // What is touched is not missed; another fixture may be.
  ProcessLimits limits = with_fixture(clamp, 0.5);
  limits.fixtures.push_back(fixture("rail", box_mesh({{-30, 2.25, -5}, {30, 4, 5}})));
  const auto both = check_in_air(pass(3.5), limits);
  REQUIRE(both.size() == 2);
  CHECK(both[0].kind == FindingKind::fixture_touched);
  CHECK(both[0].against == "clamp");
  CHECK(both[1].kind == FindingKind::near_miss);
  CHECK(both[1].against == "rail");
  CHECK(both[1].depth_mm == Approx(-0.25).margin(kTolerance / 8));
  // Each that is touched on a move is named, and each that is missed, the worst first.
  limits.fixtures.push_back(fixture("stop", box_mesh({{4.5, 1, -5}, {8, 1.5, 5}})));
  limits.fixtures.push_back(fixture("pin", box_mesh({{-30, -3, -5}, {30, -2.4, 5}})));
  const auto all = check_in_air(pass(3.5), limits);
  REQUIRE(all.size() == 4);
  CHECK(all[0].against == "stop");
  CHECK(all[1].against == "clamp");
  CHECK(all[0].depth_mm > all[1].depth_mm);
  CHECK(all[2].against == "rail");
  CHECK(all[3].against == "pin");
  CHECK(all[3].kind == FindingKind::near_miss);
}

TEST_CASE("the least distance over a triangle agrees with dense sampling", "[property][fixture]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<> wide(-12, 12), near(-5, 5);
  const auto point = [&](auto& range) { return Vec3{range(random), range(random), range(random)}; };
  const CutterProfile bodies[] = {CutterProfile(flat4(8)), CutterProfile(ball4()),
                                  CutterProfile(cutter(CutterType::bull, 6, 9, 1)),
                                  CutterProfile(cutter(CutterType::taper, 2, 10, 0.5, 12)),
                                  CutterProfile(3, 2)};
  for (int i = 0; i < 60; ++i) {
    const CutterProfile& body = bodies[i % 5];
    Vec3 to = point(near);
    const Vec3 from = point(near);
    if (i % 4 == 1) to.z = from.z;
    if (i % 4 == 2) to.x = from.x, to.y = from.y;
    if (i % 16 == 3) to = from;
    const SweptMove move(from, to, 0);
    const Vec3 a = point(wide), b = point(wide), c = point(wide);
    const double sampled = sampled_least(body, move, a, b, c);
    constexpr double kPrecision = 1e-4;
    const auto found = least_on_triangle(body, move, {a, b, c}, kForEver, kPrecision);
    REQUIRE(found);
    // Sampling is 1e-3 fine: the last grid's step on edges of up to 40 mm.
    CHECK(found->distance <= sampled + kPrecision);
    CHECK(found->distance >= sampled - 2e-3);
    CHECK(swept_distance(body, move, found->point).distance == found->distance);
    const Vec3 n = normalized(cross(b - a, c - a));
    CHECK(std::abs(dot(found->point - a, n)) < 1e-9);
    CHECK(!least_on_triangle(body, move, {a, b, c}, found->distance - kPrecision, kPrecision));
  }
}

TEST_CASE("the tree finds what a look at every triangle finds", "[property][fixture]") {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<> wide(-30, 30), small(-3, 3);
  TriangleMesh many;
  for (int k = 0; k < 60; ++k) {
    const Vec3 at{wide(random), wide(random), wide(random)};
    std::array<Vec3, 4> corners;
    for (Vec3& c : corners) c = at + Vec3{small(random), small(random), small(random)};
    const auto first = static_cast<std::uint32_t>(many.vertices.size());
    const TriangleMesh one = tetrahedron(corners);
    many.vertices.insert(many.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const auto& t : one.triangles)
      many.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const FixtureSolid tree = solid(many);
  const CutterProfile body(cutter(CutterType::bull, 6, 9, 1));
  for (int k = 0; k < 60; ++k) {
    const Vec3 from{wide(random), wide(random), wide(random)};
    const SweptMove move(from, from + Vec3{small(random), small(random), small(random)}, 0);
    double least = kForEver;
    for (const auto& t : many.triangles)
      if (const auto place = least_on_triangle(
              body, move, {many.vertices[t[0]], many.vertices[t[1]], many.vertices[t[2]]}, least,
              1e-4))
        least = place->distance;
    const auto found = tree.nearest(body, move, kForEver, 1e-4);
    REQUIRE(found);
    CHECK(found->distance == Approx(least).margin(2e-4));
    CHECK(!tree.nearest(body, move, least - 1e-3, 1e-4));
  }
}

TEST_CASE("inside and outside of a solid with corners and edges above and below",
          "[property][fixture]") {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<> x(-5, 5);
  for (int k = 0; k < 100; ++k) {
    std::array<Vec3, 4> corners;
    for (Vec3& c : corners) c = {x(random), x(random), x(random)};
    const TriangleMesh mesh = tetrahedron(corners);
    const FixtureSolid tree = solid(mesh);
    for (int i = 0; i < 50; ++i) {
      const Vec3 p{x(random), x(random), x(random)};
      CHECK(tree.encloses(p) == brute_inside(mesh, p));
    }
    // Straight below and above corners and edges.
    const Vec3 centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    CHECK(tree.encloses(centre));
    for (const Vec3& c : corners) {
      CHECK(!tree.encloses(c - Vec3{0, 0, 20}));
      CHECK(!tree.encloses(c + Vec3{0, 0, 20}));
      CHECK(!tree.encloses((c + corners[0]) / 2 - Vec3{0, 0, 20}));
    }
  }
  const FixtureSolid box = solid(box_mesh({{0, 0, 0}, {4, 4, 4}}));
  for (const double a : {1.0, 2.0, 3.0}) CHECK(box.encloses({a, a, 2}));  // on the faces' diagonal
  CHECK(!box.encloses({2, 2, -1}));
  CHECK(!box.encloses({2, 2, 5}));
}

TEST_CASE("where the solids of a fixture overlap is inside", "[unit][fixture]") {
  TriangleMesh mesh = box_mesh({{0, 0, 0}, {4, 4, 4}});
  const TriangleMesh other = box_mesh({{2, 2, 2}, {6, 6, 6}});
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + 8, b + 8, c + 8});
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  const FixtureSolid both = solid(mesh);
  for (const double a : {1.0, 3.0, 5.0}) CHECK(both.encloses({a, a, a}));
  CHECK(!both.encloses({1, 1, 5}));
}

TEST_CASE("assemblies against a fixture agree with dense sampling", "[property][fixture]") {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<> x(-8, 8);
  for (int k = 0; k < 16; ++k) {
    std::array<Vec3, 4> corners;
    for (Vec3& c : corners) c = {x(random), x(random), x(random) + 4};
    const TriangleMesh mesh = tetrahedron(corners);
    auto c = flat4(6);
    c.holder = {{12, 5}};
    const auto point = [&] { return Vec3{2 * x(random), 2 * x(random), x(random)}; };
    const Vec3 from = point();
    const auto pass = PathBuilder(from).feed(point()).pass(c);
    constexpr double kNear = 1;
    const auto all = check_in_air(pass, with_fixture(mesh, kNear));
    const SweptMove tip(from, pass.path->moves[0].to, 0);
    const simulator::ToolBodies bodies(c, 0);
    const auto least_in = [&](const simulator::ToolBody& body) {
      double least = kForEver;
      for (const auto& t : mesh.triangles)
        least = std::min(least, sampled_least(body.profile, body.of_tip(tip), mesh.vertices[t[0]],
                                              mesh.vertices[t[1]], mesh.vertices[t[2]]));
      return least;
    };
    double least_joined = kForEver;
    for (const simulator::ToolBody& body : bodies.joined)
      least_joined = std::min(least_joined, least_in(body));
    for (const simulator::ToolBody& body : {bodies.flutes, bodies.above[0]}) {
      const double least = least_in(body);
      const auto hit = std::find_if(all.begin(), all.end(),
                                    [&](const Finding& f) { return f.part == name(body.part); });
      const bool within = brute_inside(mesh, body.of_tip(tip).start + Vec3{0, 0, 2.5});
      INFO(k << " least " << least);
      if (within && least > 0) continue;
      const bool touches = of_kind(all, FindingKind::fixture_touched).size() > 0;
      if (least < -2 * kTolerance) {
        REQUIRE(hit != all.end());
        CHECK(hit->kind == FindingKind::fixture_touched);
        // A place may lie deeper in both parts together.
        CHECK(hit->depth_mm >= -least - kTolerance);
        CHECK(hit->depth_mm <= -std::min(least, least_joined) + kTolerance);
      } else if (least > kNear) {
        CHECK(hit == all.end());
      } else if (least > 0 && !touches) {
        REQUIRE(hit != all.end());
        CHECK(hit->kind == FindingKind::near_miss);
        CHECK(hit->depth_mm == Approx(-least).margin(kTolerance));
      }
    }
  }
}

TEST_CASE("moves in pieces and independent moves turned round touch as deep",
          "[property][fixture]") {
  const TriangleMesh clamp =
      tetrahedron({Vec3{4, -3, -2}, Vec3{9, 5, -3}, Vec3{2, 6, 1}, Vec3{6, 1, 8}});
  auto c = ball4();
  c.holder = {{9, 10}};
  const Vec3 stations[] = {{-9, 2, 1}, {12, 4, -2}, {3, -9, 4}, {5, 9, 2}};
  PathBuilder forth(stations[0]), back(stations[3]);
  for (int i = 1; i < 4; ++i) {
    forth.feed(stations[i]);
    back.feed(stations[3 - i]);
  }
  const auto worst = [&](const simulator::Pass& pass) {
    double depth = 0;
    for (const Finding& f : check_in_air(pass, with_fixture(clamp)))
      depth = std::max(depth, f.depth_mm);
    return depth;
  };
  const double whole = worst(forth.pass(c));
  CHECK(whole > 1);
  CHECK(worst(back.pass(c)) == Approx(whole).margin(kTolerance / 8));
  CHECK(worst(split(forth.pass(c), 7)) == Approx(whole).margin(kTolerance / 8));
}

TEST_CASE("fixtures that are no closed solid are refused", "[unit][fixture]") {
  const auto pass = PathBuilder({0, 0, 0}).feed({1, 0, 0}).pass(flat4());
  const TriangleMesh whole = box_mesh({{5, 5, 5}, {6, 6, 6}});
  CHECK(check_in_air(pass, with_fixture(whole)).empty());
  TriangleMesh open = whole, wild = whole, lost = whole;
  open.triangles.pop_back();
  wild.triangles[0][0] = 99;
  lost.vertices[0].x = std::nan("");
  TriangleMesh turned = whole;
  for (auto& t : turned.triangles) std::swap(t[1], t[2]);
  for (const TriangleMesh& mesh : {open, wild, lost, turned, TriangleMesh{}})
    CHECK_THROWS_AS(check_in_air(pass, with_fixture(mesh)), std::invalid_argument);
  ProcessLimits limits = plain_limits();
  limits.fixtures = {{"clamp", "clamp.stl", nullptr}};
  CHECK_THROWS_AS(check_in_air(pass, limits), std::invalid_argument);
}
