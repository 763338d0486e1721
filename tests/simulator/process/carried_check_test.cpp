#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>

#include "model/base/angle.h"
#include "model/base/run_control.h"
#include "simulator/process/turning/turn_check.h"
#include "tests/support/catch.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Pose;
using model::Vec3;

constexpr double kTolerance_mm = 0.02;

/// Its top is at z = 0.
StockModel carried_slab() {
  return {model::BoxStock{{-100, -100, -80}, {200, 200, 80}}, 2, std::size_t{1} << 30};
}

model::Cutter carried_cutter(double diameter_mm = 4) {
  model::Cutter made;
  made.type = model::CutterType::flat;
  made.diameter_mm = diameter_mm;
  made.flute_length_mm = 90;
  return made;
}

Vec3 corner_of(const Box3& box, int k) {
  return {k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
          k & 4 ? box.high.z : box.low.z};
}

model::Fixture box_body(const std::string& name, const Box3& box) {
  auto mesh = std::make_shared<model::TriangleMesh>();
  for (int k = 0; k < 8; ++k) mesh->vertices.push_back(corner_of(box, k));
  const std::array<std::array<std::uint32_t, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& f : faces) {
    mesh->triangles.push_back({f[0], f[1], f[2]});
    mesh->triangles.push_back({f[0], f[2], f[3]});
  }
  return {name, name + ".stl", mesh};
}

/// A spindle whose nose is 50 mm above the tip.
const Box3 kNose{{-15, -15, 50}, {15, 15, 90}};

ProcessLimits carrying(const Box3& box, const Pose& from_tip = {}, double near_miss_mm = 0) {
  ProcessLimits made;
  made.tolerance_mm = kTolerance_mm;
  made.near_miss_mm = near_miss_mm;
  made.carried.push_back({box_body("spindle", box), from_tip});
  return made;
}

Pass feeds(const Vec3& start, const std::vector<Vec3>& places,
           const model::Cutter& tool = carried_cutter()) {
  auto path = std::make_shared<model::Toolpath>();
  path->start = start;
  std::uint32_t line = 10;
  for (const Vec3& to : places) path->moves.emplace_back(to, 100.0F, line++, model::MoveKind::feed);
  return {tool, path};
}

/// Those of what is carried alone.
std::vector<Finding> of_spindle(const std::vector<Finding>& all) {
  std::vector<Finding> own;
  std::ranges::copy_if(all, std::back_inserter(own),
                       [](const Finding& f) { return f.part == "spindle"; });
  return own;
}

std::vector<Finding> spindle_findings(const Pass& pass, const ProcessLimits& limits,
                                      unsigned threads = 2) {
  static const StockModel stock = carried_slab();
  return of_spindle(check_process(stock, pass, limits, {threads, {}, {}}));
}

}  // namespace

TEST_CASE("a spindle that comes down into the stock is found with its line and depth",
          "[unit][turn]") {
  const auto met = spindle_findings(feeds({0, 0, 60}, {{0, 0, -20}, {0, 0, -52}}), carrying(kNose));
  REQUIRE(met.size() == 1);
  CHECK(met[0].kind == FindingKind::holder_in_stock);
  CHECK(met[0].line == 11);
  CHECK(met[0].against == "stock");
  CHECK(met[0].depth_mm <= 2 + 1e-9);
  CHECK(met[0].depth_mm >= 2 - 2 * kTolerance_mm);
  CHECK(met[0].point.z == Approx(-met[0].depth_mm).margin(1e-9));
}

TEST_CASE("a spindle that stays above the stock is a near miss where those are asked for",
          "[unit][turn]") {
  const Pass pass = feeds({0, 0, 60}, {{0, 0, -49.8}, {9, 3, -49.8}});
  CHECK(spindle_findings(pass, carrying(kNose)).empty());
  const auto near = spindle_findings(pass, carrying(kNose, {}, 0.5));
  REQUIRE(near.size() == 2);
  for (const Finding& f : near) {
    CHECK(f.kind == FindingKind::near_miss);
    CHECK(-f.depth_mm >= 0.2 - 1e-9);
    CHECK(-f.depth_mm <= 0.2 + kTolerance_mm);
  }
}

TEST_CASE("what the flutes have cut is in no spindle's way", "[unit][turn]") {
  const std::vector<Vec3> plunge = {{0, 0, -60}};
  CHECK(spindle_findings(feeds({0, 0, 60}, plunge, carried_cutter(50)), carrying(kNose)).empty());
  CHECK(spindle_findings(feeds({0, 0, 60}, plunge, carried_cutter(42)), carrying(kNose)).size() ==
        1);  // the nose is 42.4 mm from corner to corner
}

TEST_CASE("a spindle that rises into the stock before its flutes is found in one move as in many",
          "[unit][turn]") {
  const Vec3 from{-150, 0, -90}, to{0, 0, 10};
  const auto depth = [](const std::vector<Finding>& met) {
    double most = 0;
    for (const Finding& f : met) most = std::max(most, f.depth_mm);
    return most;
  };
  std::vector<Vec3> many;
  for (int k = 1; k <= 50; ++k) many.push_back(from + (to - from) * (k / 50.0));
  const double once =
      depth(spindle_findings(feeds(from, {to}, carried_cutter(42)), carrying(kNose)));
  const double often =
      depth(spindle_findings(feeds(from, many, carried_cutter(42)), carrying(kNose)));
  CHECK(often > 1);
  CHECK(once >= often - 2 * kTolerance_mm);
}

TEST_CASE("a spindle that touches a clamp is found, and which", "[unit][turn]") {
  ProcessLimits limits = carrying(kNose);
  limits.fixtures.push_back(box_body("left", {{-90, -10, 0}, {-70, 10, 30}}));
  limits.fixtures.push_back(box_body("right", {{70, -10, 0}, {90, 10, 30}}));
  const auto met =
      spindle_findings(feeds({0, 0, 60}, {{0, 0, -25}, {54, 0, -25}, {57, 0, -25}}), limits);
  REQUIRE(met.size() == 1);
  CHECK(met[0].kind == FindingKind::fixture_touched);
  CHECK(met[0].against == "right");
  CHECK(met[0].line == 12);
  CHECK(met[0].depth_mm == Approx(2).margin(2 * kTolerance_mm));
}

TEST_CASE("the body of a head stands as its axis has it: the depth of its lowest corner",
          "[property][turn]") {
  std::mt19937 random(5);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<>(a, b)(random);
  };
  int met_count = 0, clear_count = 0;
  for (int i = 0; i < 60; ++i) {
    Pose from_tip = model::turn_about({between(-1, 1), between(-1, 1), 0.1}, between(-80, 80));
    // Far from where the flutes cut, which a place's depth would be measured to.
    from_tip.shift_mm = {between(60, 80), between(-10, 10), between(15, 50)};
    const Vec3 from{between(-80, -60), between(-20, 20), between(-10, 20)};
    const Vec3 to{between(-80, -60), between(-20, 20), between(-40, 20)};
    const Box3 box{{-8, -12, -4}, {9, 7, 40}};
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 8; ++k)
      lowest = std::min(lowest, from_tip.point(corner_of(box, k)).z + std::min(from.z, to.z));
    const auto met = spindle_findings(feeds(from, {to}), carrying(box, from_tip));
    INFO("body " << i << ", its lowest place at " << lowest << " mm");
    if (lowest > 0) CHECK(met.empty());
    if (lowest < -1.5 * kTolerance_mm) {
      REQUIRE(met.size() == 1);
      CHECK(met[0].depth_mm <= -lowest + 1e-9);
      CHECK(met[0].depth_mm >= -lowest - 5 * kTolerance_mm);
    }
    ++(met.empty() ? clear_count : met_count);
  }
  CHECK(met_count > 10);
  CHECK(clear_count > 10);
}

TEST_CASE("one move of thousands that brings a spindle down is found, by any number of threads",
          "[unit][turn]") {
  std::vector<Vec3> places;
  for (int i = 0; i < 9000; ++i) {
    const double angle = i * 0.01;
    places.push_back({40 * std::cos(angle), 40 * std::sin(angle), i == 6203 ? -50.3 : -30});
  }
  const Pass pass = feeds({40, 0, -30}, places);
  const auto met = spindle_findings(pass, carrying(kNose));
  REQUIRE(met.size() == 2);  // down and up again
  CHECK(met[0].move == 6203);
  CHECK(met[1].move == 6204);
  const auto alone = spindle_findings(pass, carrying(kNose), 1);
  REQUIRE(alone.size() == 2);
  CHECK(alone[0].depth_mm == met[0].depth_mm);
  CHECK(alone[1].point == met[1].point);
}

TEST_CASE("a head's body that swings into the stock is found by its corner", "[unit][turn]") {
  const StockModel stock = carried_slab();
  const Box3 box{{-10, -10, 0}, {10, 10, 40}};
  // It stands on a pivot above the stock, and its far corner comes down.
  TurningPose swing;
  const Vec3 pivot{0, 0, 12};
  swing.at = [=](double t) {
    Pose pose = model::turn_about({0, 1, 0}, 100 * t);
    pose.shift_mm = pivot;
    return pose;
  };
  swing.turn_rad = 100 * std::numbers::pi / 180;
  TurningPose far_above;
  far_above.at = [](double) {
    Pose pose;
    pose.shift_mm = {0, 0, 200};
    return pose;
  };
  TurningTool motion{7, true, far_above, {}, {{swing, {}}}};
  const auto met = of_spindle(check_turn(stock, carried_cutter(), motion, carrying(box), {}));
  REQUIRE(met.size() == 1);
  CHECK(met[0].kind == FindingKind::holder_in_stock);
  CHECK(met[0].line == 7);
  double lowest = 0;  // at the end: the corner is lowest at 104 degrees
  for (int k = 0; k < 8; ++k) lowest = std::min(lowest, swing.at(1).point(corner_of(box, k)).z);
  CHECK(met[0].depth_mm <= -lowest + 1e-9);
  CHECK(met[0].depth_mm >= -lowest - 5 * kTolerance_mm);
  motion.carried.clear();
  CHECK_THROWS_AS(check_turn(stock, carried_cutter(), motion, carrying(box), {}),
                  std::invalid_argument);
}

}  // namespace limitgauge::simulator
