// The distance to a move that turns its tool, held against many poses of a cutter that is described
// a second time, and the bounds that go by it.
#include "simulator/sweep/turning/turning_move.h"

#include <algorithm>
#include <cmath>

#include "simulator/sweep/sweep_index.h"
#include "simulator/tolerance.h"
#include "tests/simulator/turning/turning_bench.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace limitgauge;
using model::Vec3;
using simulator::CutterProfile;
using simulator::SweptSample;
using simulator::TurningMove;
using namespace simulator::test;

/// Everything for one random question.
struct Question {
  model::Cutter cutter;
  CutterProfile profile;
  TurnedMove turned;
  TurningMove move;
  Vec3 p;

  explicit Question(TurningDraw& draw)
      : cutter(turning_cutters()[draw.one_of(turning_cutters().size())]),
        profile(cutter),
        turned(draw.move()),
        move(turned.move(profile)),
        p(draw.place(turned)) {}
};

SweptSample least(const Question& q, const Vec3& p) {
  return *simulator::turning_distance(q.profile, q.move, p);
}

}  // namespace

TEST_CASE("the distance to a turning move is the least over many poses", "[property][turning]") {
  TurningDraw draw(1);
  const int cases = tests::by_effort(4000, 60000);
  for (int n = 0; n < cases; ++n) {
    const Question q(draw);
    const ProfileOracle oracle(q.cutter);
    const double d = least(q, q.p).distance;
    const double brute = brute_turning_distance(oracle, q.turned, q.p, 60);
    INFO(n << ": " << model::to_text(q.cutter) << ", " << d << " for " << brute);
    // The value is that of a pose, so that it is never too small.
    CHECK(d <= brute + 2e-9);
    CHECK(d >= brute - 2e-9);
  }
}

TEST_CASE("a turning distance is that of its own time, whatever bound it is asked with",
          "[property][turning]") {
  TurningDraw draw(2);
  for (int n = 0; n < 2000; ++n) {
    const Question q(draw);
    const SweptSample s = least(q, q.p);
    CHECK(standing_distance(q.profile, q.move, q.p, s.t).distance == s.distance);
    const double bound = s.distance + draw.between(-0.5, 0.5);
    const auto bounded = turning_distance(q.profile, q.move, q.p, bound);
    CHECK(bounded.has_value() == (s.distance < bound));
    if (bounded) CHECK(bounded->distance == s.distance);
    if (cannot_be_below(q.profile, q.move, q.p, bound)) CHECK(s.distance >= bound - 1e-12);
  }
}

TEST_CASE("planes and bends hold about a turning distance", "[property][turning]") {
  TurningDraw draw(3);
  const int cases = tests::by_effort(3000, 40000);
  int tight = 0;
  for (int n = 0; n < cases; ++n) {
    const Question q(draw);
    const SweptSample s = least(q, q.p);
    const double reach = std::pow(10, draw.between(-3, 0.5));
    const double sag = turning_sag(q.profile, q.move, q.p, s, reach);
    const double bend = curvature_bound(q.profile, q.move, q.p, s, reach);
    tight += sag < 0.1 * reach;
    for (int k = 0; k < 8; ++k) {
      const Vec3 delta = draw.direction() * (reach * draw.between(0, 1));
      const double d = least(q, q.p + delta).distance;
      const double plane = s.distance + dot(s.gradient, delta);
      INFO(n << ": " << model::to_text(q.cutter));
      CHECK(d >= plane - sag - 1e-9);
      CHECK(d <= plane + bend + 1e-9);
      CHECK(std::abs(d - s.distance) <= length(delta) + 1e-9);
      const Vec3 half{std::abs(delta.x), std::abs(delta.y), std::abs(delta.z)};
      const double e = outside_bound(q.profile, q.move, q.p, s, half);
      CHECK(d <= std::max(0.0, plane + e) + 1e-9);
    }
  }
  // Not that it never says anything.
  CHECK(tight > cases / 4);
}

TEST_CASE("a ball that turns about its standing tip keeps to the arc of its centre",
          "[unit][turning]") {
  const CutterProfile ball(model::parse_cutter("ball:D=6,L=20"));
  const TurnedMove turned{{1, 2, 3}, {1, 2, 3}, {0, 0, 1}, {1, 0, 0}};
  const TurningMove move = turned.move(ball);
  TurningDraw draw(4);
  for (int n = 0; n < 500; ++n) {
    // Below the core at all times: behind both ends of the arc as the axes point.
    const Vec3 p =
        turned.from + Vec3{-draw.between(0, 4), draw.between(-4, 4), -draw.between(0, 4)};
    const Vec3 w = p - turned.from;
    // The centre at the angle a: 3 (sin a, 0, cos a); the place is beyond the tip from it, so that
    // the farthest of the arc is in its middle and one end is nearest.
    const double d = std::min(distance(w, {0, 0, 3}), distance(w, {3, 0, 0})) - 3;
    CHECK(simulator::turning_distance(ball, move, p)->distance == Approx(d).margin(1e-9));
  }
  // Above the arc's inside, where a centre is nearest that is neither end's.
  const double r = std::sqrt(0.5);
  const Vec3 between = turned.from + Vec3{r, 0, r} * 3 + Vec3{0, 2.5, 0};
  CHECK(simulator::turning_distance(ball, move, between)->distance == Approx(-0.5).margin(1e-9));
}

TEST_CASE("a move that does not turn is the upright one", "[property][turning]") {
  TurningDraw draw(5);
  for (int n = 0; n < 2000; ++n) {
    Question q(draw);
    const TurnedMove upright{q.turned.from, q.turned.to, {0, 0, 1}, {0, 0, 1}};
    const TurningMove move = upright.move(q.profile);
    const Vec3 p = draw.place(upright);
    const simulator::SweptMove plain(upright.from, upright.to, 0);
    INFO(n << ": " << model::to_text(q.cutter));
    CHECK(simulator::turning_distance(q.profile, move, p)->distance ==
          Approx(swept_distance(q.profile, plain, p).distance).margin(1e-9));
  }
}

TEST_CASE("a turning move cut in two sweeps the same", "[property][turning]") {
  TurningDraw draw(6);
  for (int n = 0; n < 2000; ++n) {
    const Question q(draw);
    const double t = draw.between(0.1, 0.9);
    const Vec3 tip = q.turned.from * (1 - t) + q.turned.to * t, axis = q.turned.axis(t);
    const TurnedMove first{q.turned.from, tip, q.turned.axis_from, axis},
        second{tip, q.turned.to, axis, q.turned.axis_to};
    const double a = simulator::turning_distance(q.profile, first.move(q.profile), q.p)->distance;
    const double b = simulator::turning_distance(q.profile, second.move(q.profile), q.p)->distance;
    CHECK(std::min(a, b) == Approx(least(q, q.p).distance).margin(1e-9));
  }
}

TEST_CASE("the tree of turning moves finds what all of them say", "[property][turning]") {
  for (unsigned seed = 0; seed < 7; ++seed) {
    const model::Cutter& cutter = turning_cutters()[seed];
    model::Pass pass = turning_pass(cutter, seed, 60);
    if (seed % 2 == 1) pass.pose = model::turn_about({1, 2, 3}, 37), pass.pose.shift_mm = {1, 2, 3};
    const simulator::SweepIndex index(pass);
    TurningDraw draw(seed);
    for (int n = 0; n < 60; ++n) {
      const Vec3 p = pass.pose.point(draw.within(13));
      std::vector<double> each;
      for (std::uint32_t slot = 0; slot < index.size(); ++slot)
        each.push_back(index.distance(slot, p).distance);
      const double least = *std::min_element(each.begin(), each.end());
      const auto found = index.nearest(p, 1e9);
      REQUIRE(found);
      CHECK(found->at.distance == least);
      const double limit = least + draw.between(0, 3);
      std::vector<std::uint32_t> near;
      index.gather(p, limit, near);
      std::sort(near.begin(), near.end());
      for (std::uint32_t slot = 0; slot < index.size(); ++slot)
        if (each[slot] <= limit && !std::binary_search(near.begin(), near.end(), slot))
          FAIL("move " << slot << " is not found");
    }
  }
}
