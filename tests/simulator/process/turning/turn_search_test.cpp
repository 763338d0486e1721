#include "simulator/process/turning/turn_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "simulator/stock/material.h"
#include "tests/simulator/process/turning/turn_bench.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using model::CutterType;
using model::Pose;
using model::Vec3;
using simulator::CutterProfile;
using simulator::Material;
using simulator::ToolBody;
using simulator::ToolPart;
using simulator::TurnAnswer;
using simulator::TurningBody;
using simulator::TurningPose;
using simulator::TurnSearch;

TurnAnswer deepest(const Material& solid, const ToolBody& body, const TurningPose& pose,
                   double tolerance = kTolerance) {
  return deepest_turn_contact(TurnSearch{&solid, &body, &pose}, tolerance, {});
}

TurnAnswer nearest(const Material& solid, const ToolBody& body, const TurningPose& pose,
                   double within) {
  return least_turn_gap(TurnSearch{&solid, &body, &pose}, within, kTolerance, {});
}

/// What a machine with a table that turns on another one does: two turns at once, and the spindle
/// goes its way.
struct TwoAxes {
  Vec3 first_axis, second_axis, first_point, second_point, from, to;
  double first_deg[2], second_deg[2];
  Pose tool;

  Pose at(double t) const {
    const auto turn = [t](const Vec3& axis, const Vec3& point, const double(&deg)[2]) {
      return shifted(point) * model::turn_about(axis, deg[0] + (deg[1] - deg[0]) * t) *
             shifted(point * -1);
    };
    return turn(first_axis, first_point, first_deg) * turn(second_axis, second_point, second_deg) *
           shifted(from + (to - from) * t) * tool;
  }
  TurningPose pose() const {
    const double first = std::abs(first_deg[1] - first_deg[0]) * M_PI / 180;
    const double second = std::abs(second_deg[1] - second_deg[0]) * M_PI / 180;
    const auto arm = [&](const Vec3& point) {
      return std::max(distance(from + tool.shift_mm, point), distance(to + tool.shift_mm, point));
    };
    const double far = arm(second_point) + distance(first_point, second_point);
    return TurningPose::even([*this](double t) { return at(t); },
                             distance(from, to) + (first + second) * far, first + second);
  }
};

class MotionDraw {
 public:
  explicit MotionDraw(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }
  Vec3 within(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  /// Its tip passes within some millimetres of the block's upper half.
  TwoAxes motion() {
    TwoAxes m;
    m.first_axis = within(1), m.second_axis = within(1);
    m.first_point = within(20), m.second_point = within(20);
    m.from = within(4), m.to = m.from + within(6);
    for (auto* deg : {&m.first_deg, &m.second_deg}) {
      (*deg)[0] = between(-50, 0), (*deg)[1] = between(0, 50);
    }
    m.tool = shifted({between(-9, 9), between(-5, 5), between(-2, 5)});
    return m;
  }

 private:
  std::mt19937_64 random_;
};

std::vector<ToolBody> bodies_to_try() {
  return {{ToolPart::cutter, CutterProfile(flat4()), 0},
          {ToolPart::cutter, CutterProfile(ball4()), 0},
          {ToolPart::cutter, CutterProfile(cutter(CutterType::taper, 2, 15, 0.5, 8)), 0},
          {ToolPart::holder, CutterProfile(8, 20), 6}};
}

/// What stands, at places of a grid, with how deep they are.
struct GridPlace {
  Vec3 p;
  double depth = 0;
};
constexpr double kGridStep = 0.5;

std::vector<GridPlace> places_of(const Material& solid) {
  std::vector<GridPlace> places;
  for (double x = -14.9; x < 15; x += kGridStep)
    for (double y = -9.9; y < 10; y += kGridStep)
      for (double z = -7.9; z < 0; z += kGridStep) {
        const double depth = -solid.sample({x, y, z}).value;
        if (depth > 0) places.push_back({{x, y, z}, depth});
      }
  return places;
}

/// The deepest of the places that the body meets, and the least distance to one that has room,
/// at so many times.
struct Sampled {
  double depth = 0, distance = std::numeric_limits<double>::infinity();
};
Sampled sampled(const std::vector<GridPlace>& places, const TurningBody& body) {
  constexpr int kTimes = 150;
  Sampled best;
  for (int k = 0; k <= kTimes; ++k)
    for (const GridPlace& place : places) {
      const double d = body.at(static_cast<double>(k) / kTimes, place.p).distance;
      if (place.depth >= kTolerance / 2) best.distance = std::min(best.distance, d);
      if (d <= 0) best.depth = std::max(best.depth, place.depth);
    }
  return best;
}

/// A contact's depth is a lower bound, as a rule within a tolerance: looking deeper ends some time.
constexpr double kShallower = 5 * kTolerance;

/// What is found is there; what a grid of places sees is found.
void check_contact(const Material& solid, const TurningBody& body, const Sampled& seen,
                   const TurnAnswer& found) {
  CHECK(found.proven);
  CHECK((found.place || seen.depth <= 1.5 * kTolerance));
  CHECK((found.place ? found.place->mm : 0) >= seen.depth - kShallower);
  if (!found.place) return;
  CHECK(found.place->mm == Approx(-solid.sample(found.place->point).value).margin(1e-9));
  CHECK(found.place->mm > kTolerance);
  CHECK(body.at(found.place->t, found.place->point).distance <= 1e-9);
}

void check_gap(const Material& solid, const TurningBody& body, const Sampled& seen,
               const TurnAnswer& found, double within) {
  CHECK(found.proven);
  CHECK((found.place ? found.place->mm : within) <= std::max(0.0, seen.distance) + 1e-9);
  if (!found.place) return;
  CHECK(solid.sample(found.place->point).value <= 1e-9);
  const double there = body.at(found.place->t, found.place->point).distance;
  CHECK(found.place->mm == Approx(std::max(0.0, there)).margin(1e-9));
}

void check_motions(unsigned seed, int count) {
  static const simulator::StockModel stock = slotted_block();
  static const std::vector<GridPlace> places = places_of(stock.material());
  const Material& solid = stock.material();
  MotionDraw draw(seed);
  int met = 0, missed = 0;
  for (int i = 0; i < count; ++i) {
    const ToolBody body = bodies_to_try()[static_cast<std::size_t>(i) % 4];
    const TurningPose pose = draw.motion().pose();
    CHECK_NOTHROW(require_bounds(pose));
    INFO("motion " << i << " of seed " << seed);
    const TurningBody turning(&body, pose);
    const Sampled seen = sampled(places, turning);
    const TurnAnswer contact = deepest(solid, body, pose);
    check_contact(solid, turning, seen, contact);
    constexpr double kWithin = 2;
    check_gap(solid, turning, seen, nearest(solid, body, pose, kWithin), kWithin);
    ++(contact.place ? met : missed);
  }
  CHECK(met > 0);
  CHECK(missed > 0);
}

}  // namespace

TEST_CASE("turns among cut stock agree with dense sampling", "[property][turn]") {
  check_motions(11, 12);
}

TEST_CASE("many turns among cut stock agree with dense sampling", "[slow][property][turn]") {
  for (const unsigned seed : {12u, 13u, 14u, 15u}) check_motions(seed, tests::by_effort(10, 40));
}

TEST_CASE("the plane under a turning body is under it", "[property][turn]") {
  MotionDraw draw(21);
  for (int i = 0; i < 400; ++i) {
    const ToolBody body = bodies_to_try()[static_cast<std::size_t>(i) % 4];
    TurningPose pose = draw.motion().pose();
    if (i % 3 == 0) pose.tip_bend_mm = std::numeric_limits<double>::infinity();
    const TurningBody turning(&body, pose);
    simulator::TurnBlock block;
    block.place.middle = draw.within(25);
    const double size = std::pow(10, draw.between(-3, 1));
    block.place.half = Vec3{draw.between(0, 1), draw.between(0, 1), draw.between(0, 1)} * size;
    block.half_t = std::pow(10, draw.between(-4, -0.302));
    block.t = draw.between(block.half_t, 1 - block.half_t);
    const simulator::TurnSample s = turning.about(block);
    CHECK(s.under.distance + s.change_mm ==
          Approx(turning.at(block.t, block.place.middle).distance).margin(1e-12));
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 60; ++k) {
      Vec3 d = block.place.half;
      for (int a = 0; a < 3; ++a)
        d[a] *= k % 2 ? draw.between(-1, 1) : std::round(draw.between(-1, 1));
      const double t = block.t + block.half_t * (k % 3 ? draw.between(-1, 1) : k % 2 * 2 - 1);
      least = std::min(least, turning.at(t, block.place.middle + d).distance -
                                  (s.under.distance + dot(s.under.gradient, d)));
    }
    CHECK(least >= -1e-9);
  }
}

TEST_CASE("bounds that are not known cost time and change nothing else", "[unit][turn]") {
  const simulator::StockModel stock = block();
  const Material& solid = stock.material();
  const ToolBody body{ToolPart::cutter, CutterProfile(flat4()), 0};
  TurningPose pose = pendulum(50.5).pose();
  const TurnAnswer known = deepest(solid, body, pose);
  pose.tip_bend_mm = std::numeric_limits<double>::infinity();
  const TurnAnswer unknown = deepest(solid, body, pose);
  REQUIRE((known.place && unknown.place));
  CHECK(known.place->mm == Approx(unknown.place->mm).margin(kTolerance));
  CHECK(known.looks <= unknown.looks);
}

TEST_CASE("a turn far from everything takes a few looks", "[unit][turn]") {
  const simulator::StockModel stock = slotted_block();
  const ToolBody body{ToolPart::holder, CutterProfile(30, 100), 60};
  const Swing far{shifted({0, 0, 300}), {0, 0, 300}, {0, 1, 0}, 0, 180};
  CHECK(deepest(stock.material(), body, far.pose()).looks < 200);
  CHECK(nearest(stock.material(), body, far.pose(), 1).looks < 200);
}

TEST_CASE("a turn that slides over a face, or in its own groove, is cleared", "[unit][turn]") {
  // About its own axis on the face, where only the first order of everything shows that nothing is
  // met, and in the groove that it has just cut about the middle of the ball.
  const simulator::StockModel raw = block();
  const ToolBody wide{ToolPart::cutter, CutterProfile(6, 20), 0};
  const Swing spin{{}, {}, {0, 0, 1}, 0, 180};
  const TurnAnswer on_face = deepest(raw.material(), wide, spin.pose(), kTolerance / 10);
  CHECK_FALSE(on_face.place);
  CHECK(on_face.proven);
  CHECK(on_face.looks < 2'000);
  const auto cut = raw.cut(PathBuilder({-20, 0, -2}).feed({0, 0, -2}).pass(ball4()), {2});
  const ToolBody ball{ToolPart::cutter, CutterProfile(ball4()), 0};
  const Swing about_middle{shifted({0, 0, -2}), {}, {0, 1, 0}, 0, -60};
  const TurnAnswer in_groove = deepest(cut.material(), ball, about_middle.pose());
  CHECK_FALSE(in_groove.place);
  CHECK(in_groove.proven);
  CHECK(in_groove.looks < 200'000);
}
