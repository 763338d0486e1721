// Passes and cutters that stood otherwise than the frame that is asked in: nothing of a verdict may
// depend on which frame that is.

#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {
namespace {

using model::Pose;
using model::Vec3;
using namespace tests;

const model::Cutter kBall{"ball", model::CutterType::ball, 4, 2, 0, 20, {}, {}};

std::vector<Pose> poses() {
  Pose over = model::turn_about({1, 0, 0}, 180);
  over.shift_mm = {0, 0, 10};
  Pose side = model::turn_about({0, 1, 0}, 90);
  side.shift_mm = {3, -7, 1};
  Pose oblique = model::turn_about({1, 2, 3}, 37);
  oblique.shift_mm = {-2, 5, 0.5};
  return {over, side, oblique};
}

/// Moves of every kind: level, up and down, ramping, and none at all.
model::Toolpath wild_path(std::mt19937& random) {
  std::uniform_real_distribution<double> at(-8, 8);
  model::Toolpath path;
  path.start = {at(random), at(random), at(random)};
  for (int i = 0; i < 40; ++i) {
    Vec3 to{at(random), at(random), at(random)};
    const Vec3& from = model::move_from(path, path.moves.size());
    if (i % 5 == 1) to.z = from.z;
    if (i % 5 == 2) to.x = from.x, to.y = from.y;
    if (i % 11 == 3) to = from;
    feed_to(path, to);
  }
  return path;
}

/// Rows 0.5 mm apart of a ball over z = height(x, y), `lift_mm` above touching it on level places.
model::Toolpath rows(const std::function<double(double, double)>& tip_z) {
  model::Toolpath path;
  path.start = {-9, -9, 20};
  for (int j = 0; j <= 32; ++j) {
    const double y = -8 + 0.5 * j;
    for (int i = 0; i <= 32; ++i) {
      const double x = (j % 2 == 0 ? -8 + 0.5 * i : 8 - 0.5 * i);
      feed_to(path, {x, y, tip_z(x, y)});
    }
  }
  return path;
}

/// A ball of radius 6 as the limit of nothing: a cube's cage, scaled, is round enough to be reached
/// from above on its upper side alone.
model::Cage round_part() {
  return scaled(cube_cage(), 8);
}

StageCheck check_of(double allowance_mm = 0) {
  StageCheck check;
  check.allowance_mm = allowance_mm;
  check.resolution_mm = 0.002;
  check.field_spacing_mm = 1;
  return check;
}

void check_near(const Interval& a, const Interval& b, double within_mm) {
  CHECK(a.low <= b.high + within_mm);
  CHECK(b.low <= a.high + within_mm);
}

}  // namespace

TEST_CASE("a pass is as far away as where it lies, whatever frame is asked in", "[property]") {
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> at(-15, 15);
  const model::Cutter cutters[] = {
      kBall,
      {"flat", model::CutterType::flat, 6, 0, 0, 20, {}, {}},
      {"bull", model::CutterType::bull, 8, 1, 0, 20, {}, {}},
      {"taper", model::CutterType::taper, 2, 1, 8, 20, {}, {}},
  };
  for (const model::Cutter& cutter : cutters)
    for (const Pose& pose : poses()) {
      const auto path = shared(wild_path(random));
      const Sweep own{CutterProfile(cutter), 0, path}, turned{CutterProfile(cutter), 0, path, pose};
      const RemovedSpace upright(std::span(&own, 1)), leaning(std::span(&turned, 1));
      for (int n = 0; n < 300; ++n) {
        const Vec3 p{at(random), at(random), at(random)};
        const Nearest a = upright.nearest(p), b = leaning.nearest(pose.point(p));
        REQUIRE(std::abs(a.distance.value - b.distance.value) < 1e-9);
        const BodyDistance there = leaning.distance(a.body, pose.point(p));
        REQUIRE(std::abs(there.value - a.distance.value) < 1e-9);
        if (std::abs(a.distance.value) > 1e-3 && a.body == b.body)
          REQUIRE(distance(pose.direction(a.distance.gradient), b.distance.gradient) < 1e-6);
        std::vector<BodyRef> near, near_too;
        upright.within(p, a.distance.value + 0.5, near);
        leaning.within(pose.point(p), a.distance.value + 0.5 + 1e-9, near_too);
        REQUIRE(near_too.size() >= near.size());
        const Vec3 ray = model::normalized({at(random), at(random), at(random)});
        const EndRule rule{1e-6, 0, 0};
        const double t = upright.first_met(p, ray, 30, rule).t_mm;
        const double t_too = leaning.first_met(pose.point(p), pose.direction(ray), 30, rule).t_mm;
        REQUIRE(std::abs(t - t_too) < 1e-4);
      }
    }
}

TEST_CASE("all bodies within a box are found of turned passes", "[property]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-15, 15), size(0, 3);
  for (const Pose& pose : poses()) {
    const auto path = shared(wild_path(random));
    const Sweep sweep{CutterProfile(kBall), 0, path, pose};
    const RemovedSpace space(std::span(&sweep, 1));
    for (int n = 0; n < 200; ++n) {
      const Vec3 low{at(random), at(random), at(random)};
      const model::Box3 box{low, low + Vec3{size(random), size(random), size(random)}};
      const double limit = size(random);
      std::vector<BodyRef> found;
      space.within(box, limit, found);
      for (int k = 0; k < 8; ++k) {
        const Vec3 corner{k & 1 ? box.low.x : box.high.x, k & 2 ? box.low.y : box.high.y,
                          k & 4 ? box.low.z : box.high.z};
        for (std::uint32_t i = 0; i < path->moves.size(); ++i)
          if (space.distance({0, i}, corner).value <= limit)
            REQUIRE(std::find(found.begin(), found.end(), BodyRef{0, i}) != found.end());
      }
    }
  }
}

TEST_CASE("a verdict is the same in every frame", "[property][slow]") {
  const model::Cage dome = paraboloid_cage(8, -0.05);
  const auto tip = [](double x, double y) { return -0.05 * (x * x + y * y) - 0.01; };
  const auto path = shared(rows(tip));
  const model::Stock block = model::BoxStock{{-10, -10, -12}, {20, 20, 14}};
  const ReferenceSurface surface(dome);
  const Pass upright{kBall, path};
  const StageDeviation known =
      measure_stage(surface, block, {&upright, 1}, nullptr, check_of(), {2});
  REQUIRE(known.gouge_mm.low > 0.005);
  for (const Pose& pose : poses()) {
    const ReferenceSurface there(turned(dome, pose));
    const Pass leaning{kBall, path, pose};
    const StageDeviation d =
        measure_stage(there, turned(block, pose), {&leaning, 1}, nullptr, check_of(), {2});
    check_near(d.gouge_mm, known.gouge_mm, 1e-9);
    check_near(d.uncut_mm, known.uncut_mm, 1e-9);
    check_near(d.unavoidable_uncut_mm, known.unavoidable_uncut_mm, 1e-9);
    CHECK(std::abs(d.proven_reach.reachable_mm2 - known.proven_reach.reachable_mm2) <
          0.01 * surface.area_mm2());
    CHECK(d.proven_reach.unreachable_mm2 <=
          known.proven_reach.unreachable_mm2 + known.proven_reach.undecided_mm2 + 1e-6);
    REQUIRE_FALSE(known.gouges.empty());
    REQUIRE_FALSE(d.gouges.empty());
    CHECK(std::abs(d.gouges.front().depth_mm - known.gouges.front().depth_mm) < 0.003);
  }
}

TEST_CASE("what one setup cannot reach is reached from another", "[unit][slow]") {
  const ReferenceSurface part(round_part());
  const model::Stock block = model::BoxStock{{-6, -6, -6}, {12, 12, 12}};
  const auto above = shared(rows([](double, double) { return 15.0; }));
  Pose over = model::turn_about({1, 0, 0}, 180);
  const std::vector<Pass> first = {{kBall, above}};
  const std::vector<Pass> both = {{kBall, above, over}, {kBall, above}};
  const double area = part.area_mm2();
  const auto one = measure_stage(part, block, first, nullptr, check_of(), {2}).proven_reach;
  CHECK(one.unreachable_mm2 > 0.35 * area);
  CHECK(one.reachable_mm2 < 0.55 * area);
  const auto two = measure_stage(part, block, both, nullptr, check_of(), {2}).proven_reach;
  CHECK(two.unreachable_mm2 == 0);
  CHECK(two.reachable_mm2 > 0.9 * area);
}

TEST_CASE("how a tool stands while it only positions is no way to reach", "[slow]") {
  // The plane seen from below, which nothing touches that stands in this frame.
  Pose over = model::turn_about({1, 0, 0}, 180);
  const ReferenceSurface seen(turned(plane_cage(8, 0, 0), over));
  const model::Stock block = model::BoxStock{{-12, -12, -20}, {24, 24, 40}};
  const model::Toolpath cuts = rows([](double, double) { return 15.0; });
  model::Toolpath rapids = cuts;
  for (model::Move& m : rapids.moves) m.kind = model::MoveKind::rapid;
  const auto reach = [&](const model::Toolpath& first, bool only_positions) {
    const std::vector<Pass> passes = {{kBall, shared(first), over, only_positions},
                                      {kBall, shared(cuts)}};
    return measure_stage(seen, block, passes, nullptr, check_of(), {2}).proven_reach;
  };
  CHECK(reach(cuts, false).unreachable_mm2 == 0);
  CHECK(reach(rapids, true).reachable_mm2 == 0);
  // A stage that forgot to cut answers for what its cutter ought to have reached.
  CHECK(reach(rapids, false).unreachable_mm2 == 0);
}

TEST_CASE("a stage that leaves more does not answer for a finer one of another setup", "[unit]") {
  const ReferenceSurface plane(plane_cage(8, 0, 0));
  const model::Stock block = model::BoxStock{{-12, -12, -20}, {24, 24, 40}};
  Pose over = model::turn_about({1, 0, 0}, 180);
  const auto level = [](double z) { return shared(rows([=](double, double) { return z; })); };
  // Finished from above to z = 0; from below everything stays 5 mm away, with 0.2 mm to leave.
  const auto finished = level(0), below = level(5);
  std::vector<Pass> passes = {{kBall, finished, over}, {kBall, below}};
  // In the second setup's frame: the plane seen from below.
  const ReferenceSurface seen(turned(plane_cage(8, 0, 0), over));
  StageCheck check = check_of(0.2);
  check.limits.has_gouge = true, check.limits.gouge_mm = 0.05;
  const model::Stock there = turned(block, over);
  CHECK(measure_stage(seen, there, passes, nullptr, check, {2}).gouge_mm.low > 0.19);
  check.finer_passes = {{0, 0, 0.05}};
  const StageDeviation own = measure_stage(seen, there, passes, nullptr, check, {2});
  CHECK(own.gouge_mm.high <= check.resolution_mm);
  CHECK(own.gouges.empty());
  // What the stage itself takes too much of is its own: through the plane by 0.3 mm.
  passes[1].path = level(-0.3);
  CHECK(measure_stage(seen, there, passes, nullptr, check, {2}).gouge_mm.low > 0.19);
}

TEST_CASE("a cut below what a finer stage of another setup left is the stage's gouge", "[unit]") {
  // Finished to z = 0; then a flute that ends 0.2 mm over the plane cuts 0.3 mm under it, in a
  // stage that was to leave 1 mm. Without the finer pass its own cut would begin under standing
  // material.
  const ReferenceSurface plane(plane_cage(8, 0, 0));
  const model::Stock block = model::BoxStock{{-12, -12, -20}, {24, 24, 40}};
  const auto level = [](double z) { return shared(rows([=](double, double) { return z; })); };
  const model::Cutter low = model::parse_cutter("flat:D=4,L=0.5");
  StageCheck check = check_of(1);
  check.limits.has_gouge = true, check.limits.gouge_mm = 0.05;
  check.finer_passes = {{0, 0, 0.02}};
  const auto gouge = [&](double finished, double cut) {
    // From beside the block, so that nothing is cut from above.
    model::Toolpath beside = rows([=](double, double) { return cut; });
    beside.start = {-20, -8, cut};
    const std::vector<Pass> passes = {{kBall, level(finished)}, {low, shared(beside)}};
    return measure_stage(plane, block, passes, nullptr, check, {2});
  };
  const StageDeviation deep = gouge(0, -0.3);
  CHECK(deep.gouge_mm.low == Approx(1.3).margin(check.resolution_mm));
  CHECK(deep.gouge_mm.high >= 1.3);
  REQUIRE(!deep.gouges.empty());
  CHECK(deep.gouges.front().stage == 1);
  CHECK(deep.gouges.front().depth_mm == Approx(deep.gouge_mm.low).margin(1e-6));
  // What the finer pass may do itself is none of it.
  CHECK(gouge(-0.015, -0.01).gouge_mm.high <= check.resolution_mm);
  CHECK(gouge(-0.015, 5).gouge_mm.high <= check.resolution_mm);
  // Of two finer ones each leaves its own.
  check.finer_passes = {{0, 0.5, 0.02}, {1, 0, 0.02}};
  const std::vector<Pass> three = {{kBall, level(0.5)}, {kBall, level(0)}, {low, level(5)}};
  CHECK(measure_stage(plane, block, three, nullptr, check, {2}).gouge_mm.high <=
        check.resolution_mm);
}

TEST_CASE("cutters that stood otherwise give the same figures for any number of threads",
          "[unit][slow]") {
  const ReferenceSurface part(round_part());
  const model::Stock block = model::BoxStock{{-6, -6, -6}, {12, 12, 12}};
  const auto low = shared(rows([](double x, double y) { return 6 - 0.05 * (x * x + y * y); }));
  const std::vector<Pass> both = {{kBall, low, model::turn_about({1, 0, 0}, 180)}, {kBall, low}};
  const StageDeviation one = measure_stage(part, block, both, nullptr, check_of(), {1});
  const StageDeviation two = measure_stage(part, block, both, nullptr, check_of(), {2});
  CHECK(one.gouge_mm.low == two.gouge_mm.low);
  CHECK(one.gouge_mm.high == two.gouge_mm.high);
  CHECK(one.uncut_mm.low == two.uncut_mm.low);
  CHECK(one.uncut_mm.high == two.uncut_mm.high);
  CHECK(one.unavoidable_uncut_mm.low == two.unavoidable_uncut_mm.low);
  CHECK(one.unavoidable_uncut_mm.high == two.unavoidable_uncut_mm.high);
  CHECK(one.proven_reach.undecided_mm2 == two.proven_reach.undecided_mm2);
  CHECK(one.proven_reach.reachable_mm2 == two.proven_reach.reachable_mm2);
  CHECK(one.cells == two.cells);
}

}  // namespace limitgauge::verifier
