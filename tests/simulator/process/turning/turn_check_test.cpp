#include "simulator/process/turning/turn_check.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>

#include "model/base/angle.h"
#include "model/base/run_control.h"
#include "tests/support/catch.h"

namespace limitgauge::simulator {
namespace {

using model::Pose;
using model::Vec3;

constexpr double kContact_mm = 0.02;

StockModel slab() {
  return {model::BoxStock{{-20, -20, -40}, {40, 40, 40}}, 0.5, std::size_t{1} << 30};
}

model::Cutter cutter(double length_mm = 20) {
  model::Cutter made;
  made.type = model::CutterType::flat;
  made.diameter_mm = 6;
  made.flute_length_mm = length_mm;
  return made;
}

ProcessLimits limits(double near_miss_mm = 0) {
  ProcessLimits made;
  made.tolerance_mm = kContact_mm;
  made.near_miss_mm = near_miss_mm;
  return made;
}

/// The tip at `tip`, the tool turned about the point `centre` along `axis` from one angle to
/// another.
TurningPose swing(const Vec3& tip, const Vec3& centre, const Vec3& axis, double from_deg,
                  double to_deg) {
  TurningPose pose;
  pose.at = [=](double t) {
    Pose turn = model::turn_about(axis, from_deg + t * (to_deg - from_deg));
    turn.shift_mm = centre + turn.direction(tip - centre);
    return turn;
  };
  pose.turn_rad = std::abs(to_deg - from_deg) * std::numbers::pi / 180;
  pose.tip_speed_mm = pose.turn_rad * length(tip - centre);
  return pose;
}

TurningTool motion(const TurningPose& pose, bool rapid = true) {
  return {7, rapid, pose, {}};
}

std::vector<Finding> check(const StockModel& stock, const model::Cutter& tool,
                           const TurningTool& turning, const ProcessLimits& with = limits()) {
  return check_turn(stock, tool, turning, with, {});
}

/// A cube about the origin.
model::Fixture clamp(double half_mm) {
  auto mesh = std::make_shared<model::TriangleMesh>();
  for (int corner = 0; corner < 8; ++corner)
    mesh->vertices.push_back({corner & 1 ? half_mm : -half_mm, corner & 2 ? half_mm : -half_mm,
                              corner & 4 ? half_mm : -half_mm});
  const std::array<std::array<std::uint32_t, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& f : faces) {
    mesh->triangles.push_back({f[0], f[1], f[2]});
    mesh->triangles.push_back({f[0], f[2], f[3]});
  }
  return {"clamp", "clamp.stl", mesh};
}

}  // namespace

TEST_CASE("a tool that swings past its ends' poses is met where it comes lowest",
          "[unit][process]") {
  const StockModel stock = slab();
  // About Y through (0, 0, 50): the tip's corner is hypot(49.5, 3) below at its lowest, and clear
  // of the slab at both ends.
  const auto pose = [](double tip_z) {
    return swing({0, 0, tip_z}, {0, 0, 50}, {0, 1, 0}, -40, 40);
  };
  CHECK(check(stock, cutter(), motion(pose(1))).empty());
  const std::vector<Finding> met = check(stock, cutter(), motion(pose(0)));
  REQUIRE(met.size() == 1);
  CHECK(met[0].kind == FindingKind::rapid_through_stock);
  CHECK(met[0].line == 7);
  CHECK(met[0].part == "cutter");
  CHECK(met[0].against == "stock");
  const double lowest_mm = std::hypot(50.0, 3.0) - 50;
  CHECK(met[0].depth_mm <= lowest_mm + 1e-9);
  CHECK(met[0].depth_mm >= lowest_mm - kContact_mm);
  CHECK(check(stock, cutter(), motion(pose(0), false))[0].kind == FindingKind::cut_while_turning);
}

TEST_CASE("what is above the flutes has findings of its own", "[unit][process]") {
  model::Cutter tool = cutter(10);
  tool.holder = {{30, 20}};
  // Leaning by 80 degrees about the tip above the slab's middle, the holder goes into it.
  const TurningPose pose = swing({0, 0, 6}, {0, 0, 6}, {0, 1, 0}, 0, 80);
  const std::vector<Finding> met = check(slab(), tool, motion(pose));
  REQUIRE(met.size() == 1);
  CHECK(met[0].kind == FindingKind::holder_in_stock);
  CHECK(met[0].part == "holder");
  // Its lower edge is 15 from the axis and 10 to 30 up it: lowest at the far end of the turn.
  const double low = model::radians(80.0), z = 6 + 10 * std::cos(low) - 15 * std::sin(low);
  CHECK(met[0].depth_mm == Approx(-z).margin(kContact_mm));
}

TEST_CASE("near misses and slight contacts of a turn", "[unit][process]") {
  const auto pose = [](double tip_z) {
    return swing({0, 0, tip_z}, {0, 0, 50}, {0, 1, 0}, -40, 40);
  };
  const double down_mm = std::hypot(49.0, 3.0) - 49;
  const std::vector<Finding> near = check(slab(), cutter(), motion(pose(1)), limits(2));
  REQUIRE(near.size() == 1);
  CHECK(near[0].kind == FindingKind::near_miss);
  CHECK(near[0].depth_mm == Approx(down_mm - 1).margin(kContact_mm));
  CHECK(check(slab(), cutter(), motion(pose(1)), limits(0.5)).empty());
  // Lifted so far that half the tolerance is left to go in.
  const double depth_mm = kContact_mm / 2;
  const double lift_mm = 50 - std::sqrt((50 + depth_mm) * (50 + depth_mm) - 9);
  const std::vector<Finding> slight = check(slab(), cutter(), motion(pose(lift_mm)));
  REQUIRE(slight.size() == 1);
  CHECK(slight[0].kind == FindingKind::slight_contact);
}

TEST_CASE("material that was cut away is room for a turn", "[unit][process]") {
  auto path = std::make_shared<model::Toolpath>();
  path->start = {-30, 0, -5};
  path->moves.emplace_back(Vec3{30, 0, -5}, 500.0F, 1, model::MoveKind::feed);
  model::Cutter wide = cutter();
  wide.diameter_mm = 30;
  const StockModel slotted = slab().cut({wide, path}, {});
  const TurningPose pose = swing({0, 0, -4}, {0, 0, 46}, {0, 1, 0}, -30, 30);
  CHECK(check(slotted, cutter(), motion(pose)).empty());
  CHECK_FALSE(check(slab(), cutter(), motion(pose)).empty());
}

TEST_CASE("fixtures turn with what they are mounted on", "[unit][process]") {
  ProcessLimits with = limits();
  with.fixtures = {clamp(5)};
  // The tool stands; in the stock's frame it stays where it is, the clamp turns by it.
  TurningTool turning = motion(swing({50, 0, 60}, {50, 0, 60}, {0, 0, 1}, 0, 0));
  turning.in_fixtures = {swing({11, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0, 90)};
  CHECK(check(slab(), cutter(), turning, with).empty());
  // Nearer, it stands clear of the clamp's side, and not of its edge.
  turning.in_fixtures = {swing({9, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0, 0)};
  CHECK(check(slab(), cutter(), turning, with).empty());
  turning.in_fixtures = {swing({9, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0, 30)};
  const std::vector<Finding> met = check(slab(), cutter(), turning, with);
  REQUIRE(met.size() == 1);
  CHECK(met[0].kind == FindingKind::fixture_touched);
  CHECK(met[0].against == "clamp");
  CHECK(distance(met[0].point, {50, 0, 60}) < 30);
  CHECK_THROWS_AS(check(slab(), cutter(), motion(turning.in_stock), with), std::invalid_argument);
}

TEST_CASE("turns against dense sampling: none missed, none invented", "[property][process]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<> part(-1, 1);
  const StockModel stock = slab();
  const model::Cutter tool = cutter();
  int contacts = 0;
  for (int n = 0; n < 60; ++n) {
    const Vec3 tip{15 * part(random), 15 * part(random), 6 + 6 * part(random)};
    const Vec3 centre = tip + Vec3{40 * part(random), 40 * part(random), 40 * part(random)};
    const Vec3 axis = model::normalized({part(random), part(random), part(random)});
    const TurningPose pose = swing(tip, centre, axis, 60 * part(random), 60 * part(random));
    double deepest_mm = -100;
    for (int k = 0; k <= 200; ++k) {
      const Pose at = pose.at(k / 200.0);
      for (int ring = 0; ring < 48; ++ring)
        for (const double z : {0.0, 10.0, 20.0}) {
          const double angle = ring * std::numbers::pi / 24;
          const Vec3 p = at.point({3 * std::cos(angle), 3 * std::sin(angle), z});
          deepest_mm = std::max(deepest_mm, -stock.exact_value(p));
        }
    }
    const std::vector<Finding> met = check(stock, tool, motion(pose));
    CAPTURE(n, deepest_mm);
    const bool found = !met.empty() && met[0].kind == FindingKind::rapid_through_stock;
    contacts += found;
    if (deepest_mm > 1.5 * kContact_mm) {
      REQUIRE(found);
      REQUIRE(met[0].depth_mm >= deepest_mm - kContact_mm);
    }
    if (!found) continue;
    // The depth is of a place of the tool: sampled as finely, it shows within the sampling's step.
    REQUIRE(-stock.exact_value(met[0].point) == Approx(met[0].depth_mm).margin(1e-6));
  }
  CHECK(contacts > 10);
  CHECK(contacts < 55);
}

TEST_CASE("a retracted tool is cleared in few looks, however far it turns", "[unit][process]") {
  int looks = 0;
  TurningPose pose = swing({0, 0, 200}, {0, 0, -100}, {1, 0, 0}, -20, 20);
  pose.at = [&looks, at = pose.at](double t) {
    ++looks;
    return at(t);
  };
  model::RunControl one;
  one.threads = 1;
  CHECK(check_turn(slab(), cutter(), motion(pose), limits(), one).empty());
  CHECK(looks < 500);
}

TEST_CASE("turns have the same findings for any number of threads", "[unit][process]") {
  model::Cutter tool = cutter(10);
  tool.holder = {{30, 20}};
  tool.shank = {{6, 5}};
  const TurningPose pose = swing({0, 0, 2}, {0, 0, 3}, {1, 2, 0}, 10, 85);
  const auto with = [&](unsigned threads) {
    model::RunControl control;
    control.threads = threads;
    return check_turn(slab(), tool, motion(pose), limits(1), control);
  };
  const std::vector<Finding> one = with(1), four = with(4);
  REQUIRE(one.size() == four.size());
  REQUIRE_FALSE(one.empty());
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].kind == four[i].kind);
    CHECK(one[i].point == four[i].point);
    CHECK(one[i].depth_mm == four[i].depth_mm);
  }
}

}  // namespace limitgauge::simulator
