#include "engine/strategy/strategies.h"

#include <cstring>

#include "engine/surface/patch_model.h"
#include "tests/engine/cages.h"
#include "tests/engine/gouge_probe.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

using namespace limitgauge;
using namespace engine;
using model::Vec3;

namespace {

strategy::StageRequest zigzag_request(const model::Box3& part) {
  strategy::StageRequest r;
  r.cut.strategy = strategy::Strategy::zigzag;
  r.cutter = model::parse_cutter("ball:D=6");
  r.cut.step_mm = 0.5;
  r.cut.tolerance_mm = 0.01;
  r.cut.feed_mm_min = 1000;
  r.cut.plunge_feed_mm_min = 300;
  r.cut.link_feed_mm_min = 1000;
  r.clearance_mm = 5;
  r.floor_z_mm = part.low.z - 3;
  r.stock = model::BoxStock{part.low - Vec3{2, 2, 5}, part.size() + Vec3{4, 4, 6}};
  return r;
}

strategy::StageRequest contour_request(const model::Box3& part) {
  strategy::StageRequest r = zigzag_request(part);
  r.cut.strategy = strategy::Strategy::contour;
  r.cutter = model::parse_cutter("flat:D=8");
  r.cut.step_mm = 1;
  r.allowance_mm = 0.2;
  r.cut.tolerance_mm = 0.05;
  return r;
}

/// Points of the limit surface itself, denser than any model is asked to be.
test::PointBins dense_points(const model::Cage& cage) {
  // A precision that no test asks for makes every patch as deep as it may be.
  const surface::PatchModel dense(cage, {1e-6, 0, 7}, {});
  std::vector<Vec3> points;
  for (const auto& patch : dense.patches())
    points.insert(points.end(), patch.limit.points.begin(), patch.limit.points.end());
  return test::PointBins(points, 1);
}

model::Cage fixture_cage(const std::string& name) {
  if (name == "plane") return test::bilinear_cage(2, 10, 0.2, -0.1, 0);
  if (name == "hypar") return test::bilinear_cage(2, 10, 0, 0, 0.03);
  if (name == "dome") return test::paraboloid_cage(6, 5, -0.02);
  if (name == "bowl") return test::paraboloid_cage(6, 5, 0.02);
  if (name == "tight bowl") return test::paraboloid_cage(6, 5, 0.25);
  return test::cube_cage(12);
}

}  // namespace

TEST_CASE("a ball zigzag never goes below the surface", "[slow][zigzag]") {
  const std::string name = GENERATE("plane", "hypar", "dome", "bowl", "tight bowl", "cube");
  const double allowance = GENERATE(0.0, 0.2);
  // Each cage once, by turns with and without an allowance; both of all take two minutes.
  const bool is_usual = (name.size() % 2 == 0) == (allowance == 0);
  if (!tests::thorough() && !is_usual) return;
  INFO(name << " allowance " << allowance);
  const model::Cage cage = fixture_cage(name);
  const surface::FinishModel finish(cage, {0.01, 3.2, 10}, {});
  auto request = zigzag_request(finish.patches().bounding_box());
  request.allowance_mm = allowance;
  const auto stage = plan_stage(finish, request, {});
  REQUIRE(stage.path.moves.size() > 100);
  const auto found = test::probe(stage.path, request.cutter, allowance, dense_points(cage), 0.2, 3);
  INFO("at " << found.where.x << " " << found.where.y << " " << found.where.z);
  CHECK(found.gouge_mm <= request.cut.tolerance_mm);
}

TEST_CASE("a ball zigzag over a plane touches it everywhere", "[property][zigzag]") {
  const model::Cage cage = fixture_cage("plane");
  const surface::FinishModel finish(cage, {0.01, 3, 10}, {});
  const auto request = zigzag_request(finish.patches().bounding_box());
  const auto stage = plan_stage(finish, request, {});
  const Vec3 normal = normalized(Vec3{-0.2, 0.1, 1});
  int touching = 0;
  for (std::size_t i = 0; i < stage.path.moves.size(); ++i) {
    const Vec3 middle = (model::move_from(stage.path, i) + stage.path.moves[i].to) * 0.5;
    const double height = dot(middle + Vec3{0, 0, 3}, normal);
    if (std::abs(middle.x) > 6 || std::abs(middle.y) > 6) continue;
    CHECK(height > 3 - request.cut.tolerance_mm);
    touching += height < 3 + request.cut.tolerance_mm;
  }
  // Rows are 0.5 mm apart: those within 6 mm of the middle follow the plane in one move each.
  CHECK(touching >= 23);
}

TEST_CASE("a flat contour keeps its allowance", "[slow][contour]") {
  const std::string name = GENERATE("plane", "dome", "bowl", "cube");
  INFO(name);
  const model::Cage cage = fixture_cage(name);
  const surface::FinishModel finish(cage, {0.01, 4.2, 10}, {});
  const auto request = contour_request(finish.patches().bounding_box());
  const auto stage = plan_stage(finish, request, {});
  REQUIRE(stage.path.moves.size() > 20);
  const auto found =
      test::probe(stage.path, request.cutter, request.allowance_mm, dense_points(cage), 0.2, 2);
  // The height map is an upper bound, so nothing but the dense points' own absence is forgiven.
  CHECK(found.gouge_mm <= 1e-9);
}

TEST_CASE("a contour clears all of an empty stock to the floor", "[property][contour]") {
  model::Cage cage = fixture_cage("plane");
  for (Vec3& v : cage.vertices) v.z -= 100;
  const surface::FinishModel finish(cage, {0.01, 4.2, 10}, {});
  auto request = contour_request({{-20, -12, 0}, {20, 12, 4}});
  request.floor_z_mm = 0;
  const auto stage = plan_stage(finish, request, {});
  const model::Box3 stock = model::bounding_box(request.stock);
  for (double x = stock.low.x; x <= stock.high.x; x += 0.5)
    for (double y = stock.low.y; y <= stock.high.y; y += 0.5) {
      double nearest = 1e9;
      for (std::size_t i = 0; i < stage.path.moves.size(); ++i) {
        const Vec3 a = model::move_from(stage.path, i), b = stage.path.moves[i].to;
        if (a.z != 0 || b.z != 0) continue;
        const Vec3 d = b - a, p{x, y, 0};
        const double t =
            length_squared(d) > 0 ? std::clamp(dot(p - a, d) / length_squared(d), 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, distance(p, a + d * t));
      }
      CHECK(nearest < 4);
    }
}

TEST_CASE("paths rapid and end above the stock only", "[property][contour][zigzag]") {
  const model::Cage cage = fixture_cage("cube");
  const surface::FinishModel finish(cage, {0.01, 4.2, 10}, {});
  const bool contour = GENERATE(false, true);
  const model::Box3 part = finish.patches().bounding_box();
  const auto request = contour ? contour_request(part) : zigzag_request(part);
  const auto stage = plan_stage(finish, request, {});
  const double top = model::bounding_box(request.stock).high.z;
  CHECK(stage.path.start.z > top);
  CHECK(stage.path.moves.back().to.z > top);
  for (std::size_t i = 0; i < stage.path.moves.size(); ++i) {
    const model::Move& move = stage.path.moves[i];
    const Vec3 from = model::move_from(stage.path, i);
    CHECK(move.to.z >= request.floor_z_mm);
    if (move.kind == model::MoveKind::feed) continue;
    const bool upright = from.x == move.to.x && from.y == move.to.y;
    CHECK((upright || (from.z > top && move.to.z > top)));
  }
}

TEST_CASE("the same path for any number of threads", "[property][contour][zigzag]") {
  const model::Cage cage = fixture_cage("cube");
  const bool contour = GENERATE(false, true);
  const auto plan = [&](unsigned threads) {
    model::RunControl control;
    control.threads = threads;
    const surface::FinishModel finish(cage, {0.01, 4.2, 10}, control);
    const model::Box3 part = finish.patches().bounding_box();
    return plan_stage(finish, contour ? contour_request(part) : zigzag_request(part), control);
  };
  const auto one = plan(1), three = plan(3);
  REQUIRE(one.path.moves.size() == three.path.moves.size());
  bool same = one.path.start == three.path.start;
  for (std::size_t i = 0; i < one.path.moves.size(); ++i)
    same = same && one.path.moves[i].to == three.path.moves[i].to;
  CHECK(same);
}

TEST_CASE("requests that no path can serve are refused by name", "[unit][contour][zigzag]") {
  const surface::FinishModel finish(fixture_cage("plane"), {0.01, 4.2, 10}, {});
  auto request = zigzag_request(finish.patches().bounding_box());
  request.cut.step_mm = 0;
  CHECK_THROWS_WITH(plan_stage(finish, request, {}), ContainsSubstring("step"));
  request = zigzag_request(finish.patches().bounding_box());
  request.allowance_mm = -1;
  CHECK_THROWS_WITH(plan_stage(finish, request, {}), ContainsSubstring("allowance"));
  request = zigzag_request(finish.patches().bounding_box());
  request.cutter = model::parse_cutter("flat:D=8");
  request.cut.scallop_mm = 0.01;
  CHECK_THROWS_WITH(plan_stage(finish, request, {}), ContainsSubstring("scallop"));
}
