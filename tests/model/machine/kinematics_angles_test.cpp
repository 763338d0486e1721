#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "tests/model/machine/kinematics_machines.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

/// What Kinematics::angles_for promises, and what its test may lose beside it.
constexpr double kPromised = 1e-9, kAnglesRounding = 1e-12;
/// Of ways: those of angles that are found by halving intervals, and what counts as equally far.
constexpr double kWay_deg = 2e-6;

Vec3 axis_by_matrices(const Kinematics& machine, const RotaryAngles& angles_deg) {
  return stand_by_matrices(machine, {}, angles_deg, 0).axis;
}

double way_deg(const RotaryAngles& a, const RotaryAngles& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

bool within_limits_of(const Kinematics& machine, const RotaryAngles& angles_deg) {
  return std::all_of(machine.axes.begin(), machine.axes.end(), [&](const RotaryAxis& axis) {
    const double angle = angles_deg[axis.index()];
    return angle >= axis.low_deg && angle <= axis.high_deg;
  });
}

/// What turns on the one side of T a = H ẑ is how far along the first axis: nothing but the second
/// axis's angle changes that, whichever kind the machine is.
double along_first(const Kinematics& machine, const Vec3& axis, double second_deg) {
  const RotaryAxis &first = machine.axes[0], &second = machine.axes[1];
  const bool heads = machine.kind == MachineKind::head_head;
  const Vec3 turned =
      applied(turn_matrix(second.direction, {}, second_deg), heads ? Vec3{0, 0, 1} : axis, 0);
  return dot(first.direction, turned) - dot(first.direction, heads ? axis : Vec3{0, 0, 1});
}

/// The second axis's angles in one turn, by halving intervals on which the side changes.
std::vector<double> second_by_halving(const Kinematics& machine, const Vec3& axis) {
  std::vector<double> found;
  constexpr int kIntervals = 360;
  for (int k = 0; k < kIntervals; ++k) {
    double low = k, high = k + 1;
    const bool side = along_first(machine, axis, low) > 0;
    if ((along_first(machine, axis, high) > 0) == side) continue;
    for (int n = 0; n < 50; ++n) {
      const double middle = (low + high) / 2;
      ((along_first(machine, axis, middle) > 0) == side ? low : high) = middle;
    }
    found.push_back(low);
  }
  return found;
}

/// The first axis's angle that brings the tool nearest to `axis`, of which it misses no more than
/// a millionth: by thirds of an arc, of which the distance has one lowest place in each half turn.
double first_by_thirds(const Kinematics& machine, const Vec3& axis, RotaryAngles angles_deg) {
  double& first = angles_deg[machine.axes[0].index()];
  const auto miss = [&](double at_deg) {
    first = at_deg;
    return distance(axis_by_matrices(machine, angles_deg), axis);
  };
  double best = 0;
  for (int k = 1; k < 36; ++k)
    if (miss(10 * k) < miss(best)) best = 10 * k;
  double low = best - 10, high = best + 10;
  for (int n = 0; n < 70; ++n) {
    const double third = (high - low) / 3;
    if (miss(low + third) < miss(high - third))
      high -= third;
    else
      low += third;
  }
  return (low + high) / 2;
}

/// The shortest way within the limits, by all whole turns that they may allow.
double shortest_way_deg(const Kinematics& machine, RotaryAngles angles_deg,
                        const RotaryAngles& from_deg) {
  double longest = 0;
  for (const RotaryAxis& axis : machine.axes) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int turn = -5; turn <= 5; ++turn) {
      const double angle = angles_deg[axis.index()] + 360 * turn;
      if (angle >= axis.low_deg && angle <= axis.high_deg)
        shortest = std::min(shortest, std::abs(angle - from_deg[axis.index()]));
    }
    longest = std::max(longest, shortest);
  }
  return longest;
}

/// Infinite where no angles within the limits do.
double shortest_way_by_halving_deg(const Kinematics& machine, const Vec3& axis,
                                   const RotaryAngles& from_deg) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const double second : second_by_halving(machine, axis)) {
    RotaryAngles angles = from_deg;
    angles[machine.axes[1].index()] = second;
    angles[machine.axes[0].index()] = first_by_thirds(machine, axis, angles);
    REQUIRE(distance(axis_by_matrices(machine, angles), axis) < 1e-6);
    shortest = std::min(shortest, shortest_way_deg(machine, angles, from_deg));
  }
  return shortest;
}

/// Limits round where the axes are and are to go, or none.
void limit_axes(Kinematics& machine, std::mt19937_64& random, const RotaryAngles& one,
                const RotaryAngles& other) {
  std::uniform_real_distribution<> room(0, 250);
  for (RotaryAxis& axis : machine.axes)
    if (one_in(random, 2)) {
      axis.low_deg = std::min(one[axis.index()], other[axis.index()]) - room(random);
      axis.high_deg = std::max(one[axis.index()], other[axis.index()]) + room(random);
    }
}

/// Of the axes that the machine has; the others stay at zero.
RotaryAngles angles_of(const Kinematics& machine, std::mt19937_64& random) {
  const RotaryAngles any = random_angles(random, 400);
  RotaryAngles angles{};
  for (const RotaryAxis& axis : machine.axes) angles[axis.index()] = any[axis.index()];
  return angles;
}

Vec3 tilted(double tilt_rad, double azimuth_rad) {
  return {std::sin(tilt_rad) * std::cos(azimuth_rad), std::sin(tilt_rad) * std::sin(azimuth_rad),
          std::cos(tilt_rad)};
}

const Kinematics kTables{MachineKind::table_table, {{'A', {1, 0, 0}, {}}, {'C', {0, 0, 1}, {}}}};
const Kinematics kHeads{MachineKind::head_head, {{'C', {0, 0, 1}, {}}, {'B', {0, 1, 0}, {}}}};
const Kinematics kMixed{MachineKind::head_table, {{'B', {0, 1, 0}, {}}, {'C', {0, 0, 1}, {}}}};

}  // namespace

TEST_CASE("the angles for an axis that can be reached put the tool along it", "[property]") {
  std::mt19937_64 random(21);
  for (int n = 0; n < 20000; ++n) {
    Kinematics machine = random_machine(random);
    const RotaryAngles from = angles_of(machine, random), there = angles_of(machine, random);
    limit_axes(machine, random, from, there);
    const Vec3 axis = axis_by_matrices(machine, there);
    const auto angles = machine.angles_for(axis, from);
    REQUIRE(angles);
    REQUIRE(distance(axis_by_matrices(machine, *angles), axis) < kPromised + kAnglesRounding);
    REQUIRE(within_limits_of(machine, *angles));
    REQUIRE(way_deg(*angles, from) <= shortest_way_deg(machine, there, from) + kWay_deg);
    for (const char word : {'A', 'B', 'C'})
      if (!machine.axis(word)) REQUIRE((*angles)[word - 'A'] == 0);
  }
}

TEST_CASE("no other angles for an axis are nearer", "[property]") {
  std::mt19937_64 random(22);
  int unreachable = 0;
  for (int n = 0; n < 300; ++n) {
    Kinematics machine = random_machine(random, n % 2 == 1, 2);
    const RotaryAngles from = angles_of(machine, random), limit = angles_of(machine, random);
    limit_axes(machine, random, from, limit);
    const Vec3 axis = random_direction(random);
    const double shortest = shortest_way_by_halving_deg(machine, axis, from);
    const auto angles = machine.angles_for(axis, from);
    REQUIRE(angles.has_value() == std::isfinite(shortest));
    if (angles)
      REQUIRE(way_deg(*angles, from) == Approx(shortest).margin(kWay_deg));
    else
      ++unreachable;
  }
  CHECK(unreachable > 30);
  CHECK(unreachable < 270);
}

TEST_CASE("where the tool stands along the axis, or it does not matter, axes stay", "[unit]") {
  for (const Kinematics& machine : {kTables, kHeads, kMixed}) {
    const RotaryAngles there =
        machine.axis('A') ? RotaryAngles{30, 0, 77} : RotaryAngles{0, 30, 77};
    CHECK(machine.angles_for(axis_by_matrices(machine, there), there) == there);
    // Upright, whatever C is; a tool that is turned on the spot tells no more after rounding.
    for (const double tilt : {0.0, 1e-14, 3e-10})
      for (const double azimuth : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
        const auto angles = machine.angles_for(tilted(tilt, azimuth), there);
        REQUIRE(angles);
        CHECK((*angles)[2] == 77);
        CHECK(std::abs((*angles)[0] + (*angles)[1]) < 1e-7);
      }
  }
}

TEST_CASE("the tool is put along axes that are all but upright", "[property]") {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<> exponent(-13, 0), azimuth(-3, 3);
  for (int n = 0; n < 6000; ++n) {
    const Kinematics& machine = n % 3 == 0 ? kTables : n % 3 == 1 ? kHeads : kMixed;
    const double tilt = std::pow(10, exponent(random)) * (one_in(random, 2) ? 1 : 0.5);
    for (const Vec3& axis : {tilted(tilt, azimuth(random)), -tilted(tilt, azimuth(random))}) {
      const auto angles = machine.angles_for(axis, angles_of(machine, random));
      CAPTURE(name(machine.kind), tilt, axis.z);
      REQUIRE(angles);
      REQUIRE(distance(axis_by_matrices(machine, *angles), axis) < kPromised + kAnglesRounding);
    }
  }
}

TEST_CASE("the tool is put along axes on the edge of what can be reached, and none beyond",
          "[unit]") {
  // B leans by 45 degrees from C: together they reach from upright to the level.
  const double half = std::sqrt(0.5), level = std::numbers::pi / 2;
  const RotaryAxis leaning{'B', {0, half, half}, {}}, round{'C', {0, 0, 1}, {}};
  for (const Kinematics& machine : {Kinematics{MachineKind::table_table, {leaning, round}},
                                    Kinematics{MachineKind::head_head, {round, leaning}},
                                    Kinematics{MachineKind::head_table, {leaning, round}}})
    for (const double azimuth : {0.0, 1.0, 2.0, 3.0}) {
      CAPTURE(name(machine.kind), azimuth);
      for (const double inside : {0.0, 1e-12, 1e-9, 1e-6})
        CHECK(machine.angles_for(tilted(level - inside, azimuth), {0, 5, 7}));
      for (const double beyond : {3e-9, 1e-6, 0.1})
        CHECK_FALSE(machine.angles_for(tilted(level + beyond, azimuth), {0, 5, 7}));
    }
}

TEST_CASE("a machine with one rotary axis reaches what lies round it", "[unit]") {
  for (const MachineKind kind :
       {MachineKind::table_table, MachineKind::head_head, MachineKind::head_table}) {
    const Kinematics machine{kind, {{'B', {0, 1, 0}, {}}}};
    const double sign = kind == MachineKind::table_table ? -1 : 1;
    const auto angles = machine.angles_for(tilted(0.5, 0), {});
    REQUIRE(angles);
    CHECK((*angles)[1] == Approx(sign * 0.5 * 180 / std::numbers::pi).epsilon(1e-14));
    CHECK_FALSE(machine.angles_for(tilted(0.5, 1e-6), {}));
  }
}

TEST_CASE("limits leave the other branch, another turn, or nothing", "[unit]") {
  Kinematics machine = kTables;
  const Vec3 axis = axis_by_matrices(machine, {30, 0, 40});
  const auto near = [](const std::optional<RotaryAngles>& angles, const RotaryAngles& expected) {
    return angles && way_deg(*angles, expected) < 1e-9;
  };
  CHECK(near(machine.angles_for(axis, {20, 0, 40}), {30, 0, 40}));
  CHECK(near(machine.angles_for(axis, {-20, 0, 200}), {-30, 0, 220}));
  CHECK(near(machine.angles_for(axis, {20, 0, 700}), {30, 0, 760}));
  machine.axes[1].high_deg = 720;
  CHECK(near(machine.angles_for(axis, {20, 0, 700}), {-30, 0, 580}));
  machine.axes[0].low_deg = -5;
  CHECK(near(machine.angles_for(axis, {20, 0, 700}), {30, 0, 400}));
  machine.axes[0].high_deg = 29;
  CHECK_FALSE(machine.angles_for(axis, {20, 0, 700}));
}

TEST_CASE("angles are at a limit, not past it by rounding", "[property]") {
  std::mt19937_64 random(24);
  for (int n = 0; n < 3000; ++n) {
    Kinematics machine = random_machine(random);
    const RotaryAngles there = angles_of(machine, random);
    for (RotaryAxis& axis : machine.axes) {
      const double limit = there[axis.index()];
      axis.low_deg = one_in(random, 2) ? limit : limit - 90;
      axis.high_deg = axis.low_deg + 90;
    }
    RotaryAngles from = there;
    for (const RotaryAxis& axis : machine.axes) from[axis.index()] = axis.low_deg + 45;
    const Vec3 axis = axis_by_matrices(machine, there);
    for (const RotaryAngles& start : {from, RotaryAngles{}}) {  // zero may lie outside
      const auto angles = machine.angles_for(axis, start);
      REQUIRE(angles);
      REQUIRE(within_limits_of(machine, *angles));
      REQUIRE(distance(axis_by_matrices(machine, *angles), axis) < kPromised + kAnglesRounding);
    }
  }
}

TEST_CASE("a tool that stands right outside the limits is no answer", "[unit]") {
  Kinematics machine = kTables;
  machine.axes[1].low_deg = -90, machine.axes[1].high_deg = 90;
  const auto angles = machine.angles_for(axis_by_matrices(machine, {30, 0, 40}), {30, 0, 400});
  REQUIRE(angles);
  CHECK(way_deg(*angles, {30, 0, 40}) < 1e-9);
}

}  // namespace limitgauge::model
