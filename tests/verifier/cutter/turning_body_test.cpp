// What a cutter sweeps along a move that turns it, held against looking at many poses.

#include "verifier/cutter/turning_body.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "model/part/cutter.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "verifier/cutter/axis_cone.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// A cutter's distance as it stands, by an evaluation of the test's own: in the tool's frame, its
/// axis given as it is.
double turned_distance(const CutterProfile& profile, const Vec3& base, const Vec3& axis,
                       const Vec3& p) {
  const Vec3 w = p - base;
  const double height = dot(w, axis);
  return closed_distance(profile, length(cross(w, axis)), height).value;
}

/// A move with what turns it, as the definition has it: an axis evenly along a great circle.
struct TurnedMove {
  Vec3 from, to, axis_from, axis_to;
  double lift_mm = 0;

  TurningBody body(const CutterProfile& profile) const {
    return {profile, from, to, axis_from, axis_to, lift_mm};
  }
  Vec3 axis(double t) const {
    const double angle = std::acos(std::clamp(dot(axis_from, axis_to), -1.0, 1.0));
    if (angle < 1e-12) return axis_from;
    return (axis_from * std::sin((1 - t) * angle) + axis_to * std::sin(t * angle)) /
           std::sin(angle);
  }
  double distance(const CutterProfile& profile, double t, const Vec3& p) const {
    return turned_distance(profile, lerp(from, to, t) + axis(t) * lift_mm, axis(t), p);
  }
};

class TurnDice {
 public:
  explicit TurnDice(unsigned seed) : random_(seed) {}

  double from(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 within(double half) { return {from(-half, half), from(-half, half), from(-half, half)}; }
  Vec3 direction() {
    for (;;)
      if (const Vec3 v = within(1); length(v) > 0.1 && length(v) < 1) return model::normalized(v);
  }
  TurnedMove move() {
    TurnedMove out{within(5), {}, direction(), {}, from(0, 1) < 0.3 ? from(0, 30) : 0};
    out.to = out.from + within(std::pow(10, from(-2, 0.6)));
    out.axis_to = model::normalized(out.axis_from + within(std::pow(10, from(-3, -0.3))));
    if (from(0, 1) < 0.1) out.axis_to = out.axis_from;
    if (from(0, 1) < 0.1) out.to = out.from;
    return out;
  }
  /// Near the body at some time, most often.
  Vec3 place(const TurnedMove& move) {
    const double t = from(0, 1);
    return lerp(move.from, move.to, t) + move.axis(t) * (move.lift_mm + from(-3, 12)) + within(8);
  }
  std::size_t one_of(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

 private:
  std::mt19937 random_;
};

const std::vector<CutterProfile>& turned_profiles() {
  static const std::vector<CutterProfile> all = [] {
    std::vector<CutterProfile> out;
    for (const char* text :
         {"ball:D=6,L=20", "bull:D=10,r=2,L=20", "flat:D=8,L=15", "taper:D=3,r=1,angle=10,L=12",
          "drill:D=6,angle=118,L=20", "ball:D=6,L=4", "apt:D=10,r=2,b=-10,L=9"})
      out.emplace_back(model::parse_cutter(text));
    out.emplace_back(model::CylinderPart{12, 30});
    return out;
  }();
  return all;
}

/// Sixteen places about one: those of a cell that is bent a little, or any.
Bezier some_cell(TurnDice& dice, const Vec3& about, double size) {
  const Vec3 u = dice.direction() * size, v = dice.direction() * size;
  Bezier cell;
  for (int k = 0; k < 16; ++k)
    cell.set(k,
             about + u * (k % 4 / 3.0 - 0.5) + v * (k / 4 / 3.0 - 0.5) + dice.within(0.05 * size));
  return cell;
}

/// A place of a cell's hull.
Vec3 hull_place(TurnDice& dice, const Bezier& cell) {
  Vec3 sum;
  double weights = 0;
  for (int k = 0; k < 16; ++k) {
    const double weight = std::pow(dice.from(0, 1), 8);
    sum += cell.control(k) * weight, weights += weight;
  }
  return sum / weights;
}

}  // namespace

TEST_CASE("the least distance along a turning move is that over many poses", "[property]") {
  TurnDice dice(1);
  const int cases = tests::by_effort(4000, 100000);
  for (int n = 0; n < cases; ++n) {
    const TurnedMove move = dice.move();
    const CutterProfile& profile = turned_profiles()[dice.one_of(turned_profiles().size())];
    const TurningBody body = move.body(profile);
    const Vec3 p = dice.place(move);
    const TurningBody::Least found = body.least(profile, p);
    CAPTURE(n, found.t, found.distance.value, found.distance.slack_mm);
    // What it names is what the tool is away at that time, and no pose comes nearer.
    REQUIRE(std::abs(move.distance(profile, found.t, p) - found.distance.value) < 1e-9);
    // Four hundred looks at a turn of 30 degrees about what is everywhere equally near.
    REQUIRE(found.distance.slack_mm < 1e-5);
    constexpr int kPoses = 200;
    for (int k = 0; k <= kPoses; ++k)
      REQUIRE(move.distance(profile, static_cast<double>(k) / kPoses, p) >
              found.distance.value - found.distance.slack_mm - 1e-9);
    // A search that is given up has seen that it may be.
    const double beyond = found.distance.value - dice.from(-1, 1);
    const double given_up = body.least(profile, p, beyond).distance.value;
    REQUIRE((given_up > beyond) == (found.distance.value > beyond));
  }
}

TEST_CASE("bounds of turning moves over a cell hold at its places and all times", "[property]") {
  TurnDice dice(2);
  const int cases = tests::by_effort(2000, 60000);
  for (int n = 0; n < cases; ++n) {
    const TurnedMove move = dice.move();
    const CutterProfile& profile = turned_profiles()[dice.one_of(turned_profiles().size())];
    const TurningBody body = move.body(profile);
    const Bezier cell = some_cell(dice, dice.place(move), std::pow(10, dice.from(-3, 0.7)));
    const Vec3 centre = middle(cell);
    std::array<Vec3, 16> points;
    for (int k = 0; k < 16; ++k) points[k] = cell.control(k);
    const double lower = body.lower(profile, points, centre);
    std::array<double, 16> values{};
    body.values(profile, cell, values);
    const double upper = *std::max_element(values.begin(), values.end());
    const model::Box3 box = control_box(cell);
    const double at_once = body.bound(profile, box.centre(), box.size() / 2);
    CAPTURE(n, lower, upper, at_once, control_radius(cell, centre));
    for (int k = 0; k < 40; ++k) {
      const Vec3 s = k < 16 ? points[k] : hull_place(dice, cell);
      const double d = body.least(profile, s).distance.value;
      REQUIRE(d > lower - 1e-9);
      REQUIRE(d > at_once);
      REQUIRE(d < upper + 1e-9);
      if (k < 16) REQUIRE(d < values[k] + 1e-9);
      REQUIRE(move.distance(profile, dice.from(0, 1), s) > lower - 1e-9);
    }
    // What is enough is proven too, where it is claimed.
    const double enough = lower + dice.from(-0.1, 0.1);
    const double asked = body.lower(profile, points, centre, enough);
    REQUIRE(asked < body.least(profile, hull_place(dice, cell)).distance.value + 1e-9);
    if (enough <= lower) REQUIRE(asked >= std::min(enough, lower) - 1e-9);
  }
}

TEST_CASE("bounds of turning moves close with the square of a cell's size", "[unit]") {
  TurnDice dice(3);
  const CutterProfile ball(model::parse_cutter("ball:D=6,L=20"));
  const CutterProfile bull(model::parse_cutter("bull:D=10,r=2,L=20"));
  for (const CutterProfile& profile : {ball, bull}) {
    // A move of 0.25 mm with a turn of 0.9 degrees, and cells that lie in its tangent plane.
    const double turn = 0.9 * std::acos(-1.0) / 180;
    const TurningBody body(profile, {0, 0, 0}, {0.25, 0, 0}, {0, 0, 1},
                           {std::sin(turn), 0, std::cos(turn)}, 0);
    double before = 0;
    for (const double size : {0.1, 0.05, 0.025, 0.0125}) {
      const TurningBody::Least at = body.least(profile, {0.11, 1.2, 0.3});
      const Vec3 n = at.distance.gradient;
      const Vec3 u = model::normalized(cross(n, Vec3{0, 1, 0})), v = cross(n, u);
      Bezier cell;
      std::array<Vec3, 16> points;
      for (int k = 0; k < 16; ++k) {
        points[k] = Vec3{0.11, 1.2, 0.3} + u * (size * (k % 4 / 3.0 - 0.5)) +
                    v * (size * (k / 4 / 3.0 - 0.5));
        cell.set(k, points[k]);
      }
      std::array<double, 16> values{};
      body.values(profile, cell, values);
      const double width = *std::max_element(values.begin(), values.end()) -
                           body.lower(profile, points, middle(cell));
      CAPTURE(size, width, before);
      CHECK(width > 0);
      // A quarter each time, but for what is not cut up further, and where a ball's chord, which
      // loses its bow whatever the size, is still the best there is.
      if (before > 0) CHECK(width < before / 2.5);
      before = width;
    }
    CHECK(before < 1e-4);
  }
}

TEST_CASE("a cone of axes bounds the distance to all that stand in it", "[property]") {
  TurnDice dice(4);
  const int cases = tests::by_effort(1000, 20000);
  for (int n = 0; n < cases; ++n) {
    const CutterProfile& profile = turned_profiles()[dice.one_of(turned_profiles().size())];
    std::vector<TurningBody> bodies;
    model::Box3 cores;
    TurnedMove move = dice.move();
    const Vec3 p = dice.place(move), half{dice.from(0, 1), dice.from(0, 1), dice.from(0, 1)};
    for (int k = 0; k < 5; ++k) {
      bodies.push_back(move.body(profile));
      cores.add(bodies.back().cores());
      const double lift = move.lift_mm;
      const Vec3 to = move.to, axis = move.axis_to;
      move = dice.move();
      move.lift_mm = lift;
      if (n % 2 == 0) move.from = to, move.axis_from = axis;
      move.to = move.from + dice.within(1);
      move.axis_to = model::normalized(move.axis_from + dice.within(0.1));
    }
    const double bound =
        AxisCone(bodies).bound(profile, farthest_from_core_mm(profile), cores, p, half);
    CAPTURE(n, bound);
    for (int k = 0; k < 40; ++k) {
      const Vec3 q =
          p + Vec3{half.x * dice.from(-1, 1), half.y * dice.from(-1, 1), half.z * dice.from(-1, 1)};
      for (const TurningBody& body : bodies)
        REQUIRE(body.least(profile, q).distance.value >= bound);
    }
  }
}

}  // namespace limitgauge::verifier
