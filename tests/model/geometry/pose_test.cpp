#include "model/geometry/pose.h"

#include <random>
#include <stdexcept>

#include "model/part/stock.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

Pose random_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<> at(-100, 100), angle(-360, 360);
  Pose pose = turn_about({at(random), at(random), at(random)}, angle(random));
  pose.shift_mm = {at(random), at(random), at(random)};
  return pose;
}

Vec3 random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<> at(-500, 500);
  return {at(random), at(random), at(random)};
}

}  // namespace

TEST_CASE("a quarter of a turn about an axis is exact", "[unit]") {
  CHECK(turn_about({0, 0, 1}, 90).point({1, 2, 3}) == Vec3{-2, 1, 3});
  CHECK(turn_about({7, 0, 0}, 90).point({1, 2, 3}) == Vec3{1, -3, 2});
  CHECK(turn_about({0, 1, 0}, -90).point({1, 2, 3}) == Vec3{-3, 2, 1});
  CHECK(turn_about({1, 0, 0}, 180).point({1, 2, 3}) == Vec3{1, -2, -3});
  CHECK(turn_about({0, 0, 1}, 360) == Pose{});
  CHECK(turn_about({0, 0, -1}, 450).rows == turn_about({0, 0, 1}, -90).rows);
  CHECK(turn_about({1, 0, 0}, 180).keeps_axes());
  CHECK_FALSE(turn_about({1, 0, 0}, 179.9).keeps_axes());
  CHECK_FALSE(Pose{}.turns());
}

TEST_CASE("a turn keeps lengths, its inverse leads back, and turns follow each other",
          "[property]") {
  std::mt19937_64 random(1);
  for (int n = 0; n < 2000; ++n) {
    const Pose a = random_pose(random), b = random_pose(random);
    const Vec3 p = random_point(random), q = random_point(random);
    REQUIRE(std::abs(distance(a.point(p), a.point(q)) - distance(p, q)) < 1e-10);
    REQUIRE(distance(a.point_back(a.point(p)), p) < 1e-10);
    REQUIRE(distance(a.inverse().point(a.point(p)), p) < 1e-10);
    REQUIRE(distance((b * a).point(p), b.point(a.point(p))) < 1e-10);
    REQUIRE(std::abs(dot(a.direction(p), a.direction(q)) - dot(p, q)) < 1e-7);
    // Right-handed.
    REQUIRE(dot(cross(a.rows[0], a.rows[1]), a.rows[2]) > 0.999999);
  }
}

TEST_CASE("the box round a turned box holds its corners, and no more than it must", "[property]") {
  std::mt19937_64 random(2);
  for (int n = 0; n < 500; ++n) {
    const Pose pose = random_pose(random);
    Box3 box, corners;
    box.add(random_point(random)), box.add(random_point(random));
    for (int k = 0; k < 8; ++k)
      corners.add(pose.point({k & 1 ? box.low.x : box.high.x, k & 2 ? box.low.y : box.high.y,
                              k & 4 ? box.low.z : box.high.z}));
    const Box3 round = pose.box(box);
    REQUIRE(distance(round.low, corners.low) < 1e-9);
    REQUIRE(distance(round.high, corners.high) < 1e-9);
    REQUIRE(pose.widening() >= 1 - 1e-12);
    REQUIRE(pose.widening() <= std::sqrt(3.0) + 1e-12);
  }
  CHECK(turn_about({1, 0, 0}, 90).widening() == 1);
  CHECK(Pose{}.box(Box3{}).empty());
}

TEST_CASE("the turn that a rotation is", "[property]") {
  std::mt19937_64 random(3);
  for (int n = 0; n < 500; ++n) {
    const Pose pose = random_pose(random);
    const Turn turn = turn_of(pose);
    REQUIRE(turn.angle_deg >= 0);
    REQUIRE(turn.angle_deg <= 180 + 1e-9);
    const Pose again = turn_about(turn.axis, turn.angle_deg);
    for (int row = 0; row < 3; ++row) REQUIRE(distance(again.rows[row], pose.rows[row]) < 1e-9);
  }
  CHECK(turn_of(Pose{}).angle_deg == 0);
}

TEST_CASE("rows are made a rotation, or refused", "[unit]") {
  const Pose known = turn_about({1, 2, 3}, 40);
  std::array<Vec3, 3> typed = known.rows;
  for (Vec3& row : typed)
    for (int k = 0; k < 3; ++k) row[k] = std::round(row[k] * 1e7) / 1e7;
  const Pose made = rotation_of(typed, 1e-6);
  for (int row = 0; row < 3; ++row) {
    CHECK(distance(made.rows[row], known.rows[row]) < 1e-7);
    CHECK(std::abs(length(made.rows[row]) - 1) < 1e-14);
  }
  CHECK_THROWS_AS(rotation_of({Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, 1e-6), std::invalid_argument);
  CHECK_THROWS_AS(rotation_of({Vec3{1, 0, 0}, {0, 1.1, 0}, {0, 0, 1}}, 1e-6),
                  std::invalid_argument);
  CHECK_THROWS_AS(rotation_of({Vec3{NAN, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1e-6),
                  std::invalid_argument);
  CHECK_THROWS_AS(turn_about({0, 0, 0}, 90), std::invalid_argument);
  CHECK_THROWS_AS(turn_about({0, 0, 1}, INFINITY), std::invalid_argument);
}

TEST_CASE("a turned block keeps its size, along the axes or leaning", "[unit]") {
  const Stock block = BoxStock{{1, 2, 3}, {4, 5, 6}};
  Pose over = turn_about({1, 0, 0}, 180);
  over.shift_mm = {0, 0, 1};
  const auto flipped = std::get<BoxStock>(turned(block, over));
  CHECK(flipped.corner_mm == Vec3{1, -7, -8});
  CHECK(flipped.size_mm == Vec3{4, 5, 6});
  const Pose oblique = turn_about({1, 1, 0}, 25);
  const auto leaning = std::get<LeaningStock>(turned(block, oblique));
  CHECK(std::get<BoxStock>(leaning.upright).size_mm == Vec3{4, 5, 6});
  CHECK(leaning.pose == oblique);
  const Box3 round = bounding_box(turned(block, oblique)),
             asked = oblique.box({{1, 2, 3}, {5, 7, 9}});
  CHECK(round.low == asked.low);
  CHECK(round.high == asked.high);
}

}  // namespace limitgauge::model
