#include "engine/strategy/axes/leaning_path.h"

#include <algorithm>
#include <cmath>

#include "engine/strategy/axes/leaning_axis.h"
#include "engine/strategy/axes/leaning_rows.h"
#include "engine/strategy/strategies.h"
#include "tests/engine/shape_cages.h"
#include "tests/support/catch.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

constexpr double kRounding = 1e-12;
const Vec3 kAlong{1, 0, 0}, kZ{0, 0, 1};

StageRequest leaning_request(const model::Box3& part, const ToolLean& lean) {
  StageRequest request;
  request.cutter = model::parse_cutter("ball:D=6,L=8,shank=6:6,holder=24:30");
  request.cut.step_mm = 0.5;
  request.cut.tolerance_mm = 0.02;
  request.cut.feed_mm_min = request.cut.link_feed_mm_min = 1000;
  request.cut.plunge_feed_mm_min = 300;
  request.clearance_mm = 5;
  request.floor_z_mm = part.low.z - 3;
  request.stock = model::BoxStock{part.low - Vec3{2, 2, 5}, part.size() + Vec3{4, 4, 6}};
  request.cut.strategy = Strategy::zigzag;
  request.cut.angle_deg = 0;
  request.cut.lean = lean;
  return request;
}

/// Where the ball's centre is at the end of each move.
std::vector<Vec3> centres(const StagePath& stage, double radius_mm) {
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < stage.path.moves.size(); ++i)
    all.push_back(stage.path.moves[i].to + stage.axes->to[i] * radius_mm);
  return all;
}

/// From a place to the straight moves between the tips of an upright ball, raised by its radius.
double off_path_mm(const model::Toolpath& upright, double radius_mm, const Vec3& p) {
  double least = 1e9;
  for (std::size_t i = 0; i < upright.moves.size(); ++i) {
    const Vec3 up = kZ * radius_mm, a = move_from(upright, i) + up,
               way = upright.moves[i].to + up - a;
    const double l2 = dot(way, way);
    const double t = l2 > 0 ? std::clamp(dot(p - a, way) / l2, 0.0, 1.0) : 0;
    least = std::min(least, distance(p, a + way * t));
  }
  return least;
}

}  // namespace

TEST_CASE("an axis leans by its tilt across the rows and by its lead along the feed", "[unit]") {
  const double root = std::sqrt(0.5);
  CHECK(distance(leaning_axis(kZ, kAlong, 1, {0, 45}), {0, root, root}) < kRounding);
  CHECK(distance(leaning_axis(kZ, kAlong, -1, {0, 45}), {0, root, root}) < kRounding);
  CHECK(distance(leaning_axis(kZ, kAlong, 1, {45, 0}), {root, 0, root}) < kRounding);
  CHECK(distance(leaning_axis(kZ, kAlong, -1, {45, 0}), {-root, 0, root}) < kRounding);
  CHECK(distance(leaning_axis(kZ, kAlong, 0, {45, 0}), kZ) < kRounding);
  // From a slope across the rows by its own angle: upright again.
  const Vec3 slope = normalized(Vec3{0, -std::tan(0.4), 1});
  CHECK(distance(leaning_axis(slope, kAlong, 1, {0, 0.4 / model::radians(1)}), kZ) < kRounding);
}

TEST_CASE("a holder hangs below a leaning ball by the closed form", "[unit]") {
  const auto cutter = model::parse_cutter("ball:D=6,L=8,holder=40:30");
  CHECK(hang_mm(cutter, kZ) == 0);
  const double a = model::radians(60);
  const Vec3 axis{std::sin(a), 0, std::cos(a)};
  CHECK(hang_mm(cutter, axis) == Approx(20 * std::sin(a) - 5 * std::cos(a) - 3).margin(kRounding));
}

TEST_CASE("the centre of a leaning ball goes where it goes upright", "[property]") {
  const model::Cage cage = test::paraboloid_cage(4, 5, -0.03);
  const surface::FinishModel finish(cage, {0.005, 3.02, 10}, {});
  for (const ToolLean& lean :
       {ToolLean{0, 30}, ToolLean{10, -25}, ToolLean{5, 15, LeanFrom::surface}}) {
    const StageRequest request = leaning_request(finish.patches().bounding_box(), lean);
    StageRequest ball = request;
    ball.cutter.shank.clear(), ball.cutter.holder.clear();
    const StagePath upright = plan_zigzag(finish, ball, {});
    const StagePath leant = plan_stage(finish, request, {});
    REQUIRE(leant.axes.has_value());
    REQUIRE_NOTHROW(require_axes(leant.path, *leant.axes));
    const double most_turn =
        std::sqrt(8 * kBowShare * request.cut.tolerance_mm / request.cutter.radius_mm());
    const auto places = centres(leant, request.cutter.radius_mm());
    double worst = 0, turn = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (leant.path.moves[i].kind != model::MoveKind::feed) continue;
      worst = std::max(worst, off_path_mm(upright.path, request.cutter.radius_mm(), places[i]));
      // What sets out from the air has turned there.
      turn = std::max(turn, model::angle_between(axis_from(*leant.axes, i), leant.axes->to[i]));
    }
    CHECK(worst < 1e-9);
    CHECK(turn <= most_turn + 1e-9);
    CHECK(distance(leant.axes->start, kZ) == 0);
    CHECK(distance(leant.axes->to.back(), kZ) < kRounding);
  }
}

TEST_CASE("on a level plane rows have the tilt and lead that are asked for", "[unit]") {
  const model::Cage cage = test::bilinear_cage(2, 10, 0, 0, 0);
  const surface::FinishModel finish(cage, {0.005, 3.02, 10}, {});
  for (const LeanFrom from : {LeanFrom::vertical, LeanFrom::surface}) {
    const ToolLean lean{0, 20, from};
    const StagePath leant =
        plan_stage(finish, leaning_request(finish.patches().bounding_box(), lean), {});
    const Vec3 axis = leaning_axis(kZ, kAlong, 1, lean);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < leant.path.moves.size(); ++i) {
      const Vec3 centre = leant.path.moves[i].to + leant.axes->to[i] * 3;
      // Half a radius from the rim the surface's normal is that of the plane.
      const model::Box3 part = finish.patches().bounding_box();
      if (leant.path.moves[i].kind != model::MoveKind::feed || centre.x < part.low.x + 1.6 ||
          centre.x > part.high.x - 1.6 || centre.y < part.low.y + 1.6 ||
          centre.y > part.high.y - 1.6)
        continue;
      ++inside;
      CHECK(distance(leant.axes->to[i], axis) < 1e-5);
    }
    if (from == LeanFrom::surface) CHECK(inside > 10);
  }
}

TEST_CASE("rows lean for a ball's zigzag alone", "[unit]") {
  const surface::FinishModel finish(test::bilinear_cage(2, 10, 0.2, -0.1, 0), {0.01, 3.02, 10}, {});
  StageRequest request = leaning_request(finish.patches().bounding_box(), {0, 20});
  request.cut.boundary_pass = true;
  CHECK_THROWS_AS(plan_stage(finish, request, {}), std::invalid_argument);
  request.cut.boundary_pass = false;
  request.cut.lean->tilt_deg = 61;
  CHECK_THROWS_AS(plan_stage(finish, request, {}), std::invalid_argument);
  request.cut.lean->tilt_deg = 20;
  request.cutter = model::parse_cutter("flat:D=6");
  CHECK_THROWS_AS(plan_stage(finish, request, {}), std::invalid_argument);
}

}  // namespace limitgauge::engine::strategy
