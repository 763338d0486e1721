#include "model/gcode/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "model/gcode/program_path.h"
#include "model/text/fixed_number.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

constexpr int kDecimals = 4;

/// A point of a plane's axes at `level` along its normal, rounded as the writer rounds.
Vec3 placed(ArcPlane plane, double one, double two, double level) {
  const auto [a, b, normal] = axes_of(plane);
  Vec3 point;
  point[a] = one, point[b] = two, point[normal] = level;
  return rounded(point, kDecimals);
}

struct Circle {
  double one = 0, two = 0, radius = 1;
};

/// Chords of `circle` from angle `begin` on, `step` radians each.
Toolpath chords(ArcPlane plane, const Circle& circle, double begin, double step, int count) {
  Toolpath path;
  const auto at = [&](int i) {
    const double angle = begin + step * i;
    return placed(plane, circle.one + circle.radius * std::cos(angle),
                  circle.two + circle.radius * std::sin(angle), 1.5);
  };
  path.start = at(0);
  for (int i = 1; i <= count; ++i) path.moves.emplace_back(at(i), 500.0F, 0, MoveKind::feed);
  return path;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = length_squared(along);
  const double at = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return distance(p, a + along * at);
}

/// Greatest distance of samples of `a`'s moves from `b`'s.
double farthest(const Toolpath& a, const Toolpath& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 p = lerp(move_from(a, i), a.moves[i].to, t);
      double least = distance(p, b.start);
      for (std::size_t j = 0; j < b.moves.size(); ++j)
        least = std::min(least, distance_to_segment(p, move_from(b, j), b.moves[j].to));
      most = std::max(most, least);
    }
  }
  return most;
}

/// The arc as a control moves, in chords that are too short to matter.
Toolpath as_chords(const FittedArc& arc, const Vec3& start, const Vec3& end) {
  Program program;
  Motion begin;
  begin.to = start;
  program.motions.push_back(begin);
  Motion motion;
  motion.kind = MotionKind::arc;
  motion.plane = arc.plane;
  motion.to = end;
  motion.feed_mm_min = 100;
  const auto [one, two, normal] = axes_of(arc.plane);
  motion.centre1 = start[one] + arc.offset.x;
  motion.centre2 = start[two] + arc.offset.y;
  motion.turns = arc.counter_clockwise ? 1 : -1;
  program.motions.push_back(motion);
  return to_toolpath(program, 1e-5);
}

Toolpath part_of(const Toolpath& path, std::size_t first, std::size_t count) {
  Toolpath part;
  part.start = move_from(path, first);
  part.moves.assign(path.moves.begin() + static_cast<std::ptrdiff_t>(first),
                    path.moves.begin() + static_cast<std::ptrdiff_t>(first + count));
  return part;
}

}  // namespace

TEST_CASE("chords of a quarter circle become one arc in every plane", "[unit][arc]") {
  for (const ArcPlane plane : {ArcPlane::xy, ArcPlane::zx, ArcPlane::yz}) {
    for (const double way : {1.0, -1.0}) {
      const Toolpath path = chords(plane, {3, -2, 10}, 0.4, way * std::numbers::pi / 100, 50);
      // Sagitta of a chord: 10 (1 - cos(pi / 200)) = 0.0012 mm.
      const std::optional<FittedArc> arc = ArcFitter(path, 0.002, kDecimals).from(0);
      REQUIRE(arc.has_value());
      CHECK(arc->moves == 50);
      CHECK(arc->plane == plane);
      CHECK(arc->counter_clockwise == (way > 0));
      // The circle may shrink by what its points may stand off: within 0.002 / (1 - cos 45°).
      CHECK(length(arc->offset) == Approx(10).margin(0.01));
    }
  }
}

TEST_CASE("an arc turns by half a turn at most", "[unit][arc]") {
  const Toolpath path = chords(ArcPlane::xy, {0, 0, 5}, 0, std::numbers::pi / 180, 360);
  ArcFitter fitter(path, 0.002, kDecimals);
  std::size_t at = 0;
  int arcs = 0;
  while (at < path.moves.size()) {
    const std::optional<FittedArc> arc = fitter.from(at);
    REQUIRE(arc.has_value());
    CHECK(arc->moves <= 180);
    at += arc->moves;
    ++arcs;
  }
  CHECK(arcs <= 3);
}

TEST_CASE("no arc stands for what is no arc", "[unit][arc]") {
  const auto none = [](const Toolpath& path, double tolerance_mm) {
    for (std::size_t i = 0; i < path.moves.size(); ++i)
      CHECK_FALSE(ArcFitter(path, tolerance_mm, kDecimals).from(i).has_value());
  };
  SECTION("chords that lie farther inside than the tolerance") {
    // Sagitta 10 (1 - cos(pi / 20)) = 0.123 mm.
    none(chords(ArcPlane::xy, {0, 0, 10}, 0, std::numbers::pi / 10, 9), 0.05);
  }
  SECTION("fewer than three moves") {
    none(chords(ArcPlane::xy, {0, 0, 10}, 0, 0.01, 2), 0.01);
  }
  SECTION("a straight row") {
    Toolpath row;
    for (int i = 1; i < 20; ++i)
      row.moves.emplace_back(Vec3{i * 1.0, 0, 0}, 1.0F, 0, MoveKind::feed);
    none(row, 0.01);
  }
  SECTION("a radius beyond a metre") {
    none(chords(ArcPlane::xy, {0, 0, 1200}, 0, 0.001, 50), 0.0001);
  }
  SECTION("moves that leave every plane") {
    Toolpath path = chords(ArcPlane::xy, {0, 0, 10}, 0, 0.01, 30);
    for (std::size_t i = 0; i < path.moves.size(); ++i)
      path.moves[i].to.z += 0.001 * static_cast<double>(i + 1);
    none(path, 0.01);
  }
  SECTION("rapids") {
    Toolpath path = chords(ArcPlane::xy, {0, 0, 10}, 0, 0.01, 30);
    for (Move& move : path.moves) move.kind = MoveKind::rapid;
    none(path, 0.01);
  }
  SECTION("a corner") {
    Toolpath path;
    for (const Vec3& to : {Vec3{5, 0, 0}, Vec3{5, 5, 0}, Vec3{0, 5, 0}})
      path.moves.emplace_back(to, 1.0F, 0, MoveKind::feed);
    none(path, 0.01);
  }
}

TEST_CASE("an arc ends where the feed rate or the plane changes", "[unit][arc]") {
  Toolpath path = chords(ArcPlane::yz, {0, 0, 10}, 0.2, 0.01, 30);
  for (std::size_t i = 20; i < 30; ++i) path.moves[i].feed_mm_min = 400;
  CHECK(ArcFitter(path, 0.002, kDecimals).from(0)->moves == 20);
  CHECK(ArcFitter(path, 0.002, kDecimals).from(20)->moves == 10);
  path.moves[12].to.x += 0.001;
  CHECK(ArcFitter(path, 0.002, kDecimals).from(0)->moves == 12);
}

TEST_CASE("arcs and the moves they stand for keep within the tolerance, both ways",
          "[property][arc]") {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> number(0, 1);
  int found = 0;
  for (int round = 0; round < 150; ++round) {
    const double tolerance_mm = std::pow(10, -3 + 2 * number(random));
    const ArcPlane plane = std::array{ArcPlane::xy, ArcPlane::zx, ArcPlane::yz}[random() % 3];
    // Arcs of two circles and noise: some of it fits, some does not.
    const Circle circle = {20 * number(random), 20 * number(random), 0.2 + 20 * number(random)};
    const double step = std::sqrt(8 * tolerance_mm / circle.radius) * (0.3 + 0.8 * number(random));
    const double way = random() % 2 == 0 ? 1 : -1;
    Toolpath path = chords(plane, circle, 6 * number(random), way * step, 40);
    const auto [one, two, normal] = axes_of(plane);
    const double noise_mm = tolerance_mm * (random() % 3 == 0 ? 1.5 : 0.3);
    for (Move& move : path.moves) {
      move.to[one] += noise_mm * (number(random) - 0.5);
      move.to[two] += noise_mm * (number(random) - 0.5);
      if (random() % 15 == 0) move.to = path.start;
      move.to = rounded(move.to, kDecimals);
    }
    ArcFitter fitter(path, tolerance_mm, kDecimals);
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const std::optional<FittedArc> arc = fitter.from(i);
      if (!arc) continue;
      ++found;
      CHECK(arc->moves >= 3);
      const Toolpath run = part_of(path, i, arc->moves);
      const Toolpath turned = as_chords(*arc, run.start, run.moves.back().to);
      // The chords that stand for the arc here are within 1e-5 mm of it.
      CHECK(farthest(run, turned) <= tolerance_mm + 1e-5 + 1e-12);
      CHECK(farthest(turned, run) <= tolerance_mm + 1e-5 + 1e-12);
      CHECK(distance(turned.moves.back().to, run.moves.back().to) == 0);
      // Half a turn at most: no longer than pi times the radius.
      const double radius = length(arc->offset);
      CHECK(lengths(turned, 0).cut_mm <= std::numbers::pi * radius + 0.01);
    }
  }
  CHECK(found > 500);
}
