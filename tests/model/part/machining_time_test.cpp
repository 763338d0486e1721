#include "model/part/machining_time.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

constexpr double kFeed_mm_min = 3000;  // 50 mm/s
constexpr double kSpeed_mm_s = 50;
constexpr double kAcceleration_mm_s2 = 500;
constexpr double kDeviation_mm = 0.02;

MachineRates machine(double acceleration_mm_s2 = kAcceleration_mm_s2) {
  return {6000, acceleration_mm_s2, kDeviation_mm};
}

void feed_to(Toolpath& path, const Vec3& to, double feed_mm_min = kFeed_mm_min) {
  path.moves.emplace_back(to, static_cast<float>(feed_mm_min), 0, MoveKind::feed);
}

Toolpath feed_along(std::initializer_list<Vec3> points) {
  Toolpath path;
  for (const Vec3& point : points) feed_to(path, point);
  return path;
}

/// From rest over `length` to rest: a trapezoid where it reaches `speed`.
double rest_to_rest_s(double length, double speed, double acceleration) {
  if (speed * speed / acceleration <= length) return length / speed + speed / acceleration;
  return 2 * std::sqrt(length / acceleration);
}

/// From rest to `end` over `length`, where `speed` is reached on the way.
double rest_to_speed_s(double length, double speed, double end, double acceleration) {
  const double up_mm = speed * speed / (2 * acceleration);
  const double down_mm = (speed * speed - end * end) / (2 * acceleration);
  return speed / acceleration + (speed - end) / acceleration + (length - up_mm - down_mm) / speed;
}

Toolpath random_timed_path(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  Toolpath path;
  Vec3 at;
  for (int i = 0; i < 60; ++i) {
    const double step_mm = std::pow(10, 2 * number(random) - 0.5);
    if (random() % 10 != 0) at += Vec3{number(random), number(random), number(random)} * step_mm;
    path.moves.emplace_back(at, static_cast<float>(200 + 100 * static_cast<double>(random() % 40)),
                            0, random() % 5 == 0 ? MoveKind::rapid : MoveKind::feed);
  }
  return path;
}

}  // namespace

TEST_CASE("one move is a trapezoid of speed, or a triangle where it is short", "[unit][time]") {
  // Up and down take 2.5 mm each.
  CHECK(machining_time_s(feed_along({{100, 0, 0}}), machine()) == Approx(100 / 50.0 + 0.1));
  CHECK(machining_time_s(feed_along({{0, 5, 0}}), machine()) == Approx(0.2));
  CHECK(machining_time_s(feed_along({{0, 0, 2}}), machine()) == Approx(2 * std::sqrt(2 / 500.0)));
}

TEST_CASE("rapids go at the rapid rate", "[unit][time]") {
  Toolpath path;
  path.moves = {{{200, 0, 0}, 0, 0, MoveKind::rapid}};
  CHECK(machining_time_s(path, machine()) == Approx(rest_to_rest_s(200, 100, 500)));
}

TEST_CASE("moves in line are one move", "[unit][time]") {
  const double whole = rest_to_rest_s(10, kSpeed_mm_s, kAcceleration_mm_s2);
  CHECK(machining_time_s(feed_along({{3, 0, 0}, {10, 0, 0}}), machine()) == Approx(whole));
  Toolpath many;
  for (int i = 1; i <= 1000; ++i) feed_to(many, {0.01 * i, 0, 0});
  CHECK(machining_time_s(many, machine()) == Approx(whole));
  // So are moves with one of no length between them.
  CHECK(machining_time_s(feed_along({{3, 0, 0}, {3, 0, 0}, {10, 0, 0}}), machine()) ==
        Approx(whole));
}

TEST_CASE("a slower feed ahead is reached before its move begins", "[unit][time]") {
  Toolpath path;
  feed_to(path, {20, 0, 0});
  feed_to(path, {40, 0, 0}, 600);
  // 50 mm/s down to 10 mm/s on the first move; to rest from 10 mm/s on the second.
  const double first = rest_to_speed_s(20, 50, 10, 500);
  CHECK(machining_time_s(path, machine()) == Approx(first + 20 / 10.0 + 10 / (2 * 500.0)));
}

TEST_CASE("a right angle is passed on the circle of the junction deviation", "[unit][time]") {
  const double s = std::sqrt(0.5);
  const double corner = std::sqrt(kAcceleration_mm_s2 * kDeviation_mm * s / (1 - s));
  CHECK(corner_speed_squared({1, 0, 0}, 20, {0, 1, 0}, 30, kAcceleration_mm_s2, kDeviation_mm) ==
        Approx(corner * corner));
  const double each = rest_to_speed_s(20, kSpeed_mm_s, corner, kAcceleration_mm_s2);
  CHECK(machining_time_s(feed_along({{20, 0, 0}, {20, 20, 0}}), machine()) == Approx(2 * each));
}

TEST_CASE("a reversal is a stop", "[unit][time]") {
  CHECK(corner_speed_squared({1, 0, 0}, 9, {-1, 0, 0}, 9, 500, 0.02) == 0);
  CHECK(machining_time_s(feed_along({{20, 0, 0}, {0, 0, 0}}), machine()) ==
        Approx(2 * rest_to_rest_s(20, kSpeed_mm_s, kAcceleration_mm_s2)));
}

TEST_CASE("chords of a circle are as fast as its radius allows", "[unit][time]") {
  constexpr double kRadius_mm = 2;
  constexpr int kChords = 2000, kTurns = 5;
  Toolpath path;
  path.start = {kRadius_mm, 0, 0};
  for (int i = 1; i <= kChords * kTurns; ++i) {
    const double angle = 2 * std::numbers::pi * i / kChords;
    feed_to(path, {kRadius_mm * std::cos(angle), kRadius_mm * std::sin(angle), 0});
  }
  // The inscribed circle's radius: v² = a r. 31.6 mm/s, below the feed.
  const double inner_mm = kRadius_mm * std::cos(std::numbers::pi / kChords);
  const double top = std::sqrt(kAcceleration_mm_s2 * inner_mm);
  const double around_mm = kTurns * kChords * 2 * kRadius_mm * std::sin(std::numbers::pi / kChords);
  // Between two corners the speed may rise by a t, for one chord's time: 1e-4 of the whole.
  CHECK(machining_time_s(path, machine()) ==
        Approx(around_mm / top + top / kAcceleration_mm_s2).epsilon(1e-3));
}

TEST_CASE("limits never make a path faster, and a stronger drive never slower",
          "[property][time]") {
  std::mt19937 random(31);
  for (int round = 0; round < 200; ++round) {
    const Toolpath path = random_timed_path(random);
    const double bound = lengths(path, 6000).time_s;
    double last = std::numeric_limits<double>::infinity();
    for (const double acceleration : {1.0, 30.0, 400.0, 5000.0, 1e6, 1e12}) {
      const double time = machining_time_s(path, machine(acceleration));
      // Sixty roundings of sums are below 1e-13 of them.
      CHECK(time >= bound * (1 - 1e-13));
      CHECK(time <= last * (1 + 1e-13));
      last = time;
    }
    CHECK(last == Approx(bound).epsilon(1e-4));
    CHECK(machining_time_s(path, {6000, std::nullopt, kDeviation_mm}) == bound);
  }
}

TEST_CASE("a path is as fast backwards", "[property][time]") {
  std::mt19937 random(32);
  for (int round = 0; round < 100; ++round) {
    const Toolpath path = random_timed_path(random);
    Toolpath back;
    back.start = path.moves.back().to;
    for (std::size_t i = path.moves.size(); i-- > 0;)
      back.moves.emplace_back(move_from(path, i), path.moves[i].feed_mm_min, 0, path.moves[i].kind);
    CHECK(machining_time_s(back, machine()) == Approx(machining_time_s(path, machine())));
  }
}

TEST_CASE("figures of a machine that cannot be are refused", "[unit][time]") {
  CHECK_THROWS_AS(machining_time_s({}, machine(0)), std::invalid_argument);
  CHECK_THROWS_AS(machining_time_s({}, machine(-1)), std::invalid_argument);
  CHECK_THROWS_AS(machining_time_s({}, {6000, 100, 0}), std::invalid_argument);
  CHECK(machining_time_s({}, machine()) == 0);
}
