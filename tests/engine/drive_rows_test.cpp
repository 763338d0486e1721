#include "engine/strategy/rows/ball_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/strategy/strategies.h"
#include "engine/surface/patch_model.h"
#include "tests/engine/cages.h"
#include "tests/engine/gouge_probe.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine;
using model::Vec3;

namespace {

strategy::StageRequest ball_request(const model::Box3& part, double angle_deg) {
  strategy::StageRequest r;
  r.cut.strategy = strategy::Strategy::zigzag;
  r.cut.angle_deg = angle_deg;
  r.cut.step_mm = 0.8;
  r.cut.tolerance_mm = 0.01;
  r.cut.feed_mm_min = 1000;
  r.cut.plunge_feed_mm_min = 300;
  r.cutter = model::parse_cutter("ball:D=6");
  r.clearance_mm = 5;
  r.floor_z_mm = part.low.z - 3;
  r.stock = model::BoxStock{part.low - Vec3{2, 2, 5}, part.size() + Vec3{4, 4, 6}};
  return r;
}

std::vector<Vec3> limit_points(const model::Cage& cage, int depth) {
  // A precision that no test asks for makes every patch as deep as it may be.
  const surface::PatchModel dense(cage, {1e-6, 0, depth}, {});
  std::vector<Vec3> points;
  for (const auto& patch : dense.patches())
    points.insert(points.end(), patch.limit.points.begin(), patch.limit.points.end());
  return points;
}

double distance_to_move(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double l2 = length_squared(d);
  return distance(p, a + d * (l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0.0));
}

/// What stands over `p` when a ball of `radius_mm` has cut the rows.
double left_over(const strategy::DriveRows& rows, const Vec3& p, double radius_mm) {
  double nearest = std::numeric_limits<double>::infinity();
  const Vec3 up{0, 0, radius_mm};
  for (const auto& row : rows.rows)
    for (const auto& run : row.runs)
      for (std::size_t i = 1; i < run.size(); ++i)
        nearest = std::min(nearest, distance_to_move(p, run[i - 1] + up, run[i] + up));
  return nearest - radius_mm;
}

/// Two plates 5 mm apart in height with a gap of `gap` cells of 5 mm between them, along Y.
model::Cage plates(int gap) {
  const int n = 10, low = 4;
  model::Cage cage = test::grid_cage(n, 5, [=](double, double y) { return y < 0 ? 0.0 : 5.0; });
  for (int j = low; j < low + gap; ++j)
    for (int i = 0; i < n; ++i) cage.holes.push_back(j * n + i);
  return cage;
}

}  // namespace

TEST_CASE("rows at any angle keep off the surface", "[property][zigzag]") {
  for (const bool cube : {false, true}) {
    const model::Cage cage = cube ? test::cube_cage(12) : test::paraboloid_cage(6, 5, 0.05);
    const surface::FinishModel finish(cage, {0.01, 3.2, 10}, {});
    const test::PointBins points(limit_points(cage, 4), 1);
    for (const double angle : {0.0, 30.0, 90.0, 135.0, -250.0})
      for (const auto pattern : {strategy::RowPattern::zigzag, strategy::RowPattern::one_way}) {
        INFO("angle " << angle << " cube " << cube);
        auto request = ball_request(finish.patches().bounding_box(), angle);
        request.cut.pattern = pattern;
        request.allowance_mm = 0.2;
        const auto stage = plan_stage(finish, request, {});
        const auto found = test::probe(stage.path, request.cutter, 0.2, points, 0.3, 23);
        CHECK(found.gouge_mm <= request.cut.tolerance_mm);
        CHECK(stage.sampling_intervals.size() == finish.patches().patches().size());
      }
  }
}

TEST_CASE("rows lie in their planes and run their way", "[unit][zigzag]") {
  const surface::FinishModel finish(test::paraboloid_cage(6, 5, -0.02), {0.01, 3, 10}, {});
  const double angle = GENERATE(0.0, 30.0, 90.0, 200.0);
  const auto request = ball_request(finish.patches().bounding_box(), angle);
  const auto rows = make_ball_rows(finish.patches(), request, {});
  const double a = angle * std::numbers::pi / 180;
  const Vec3 along{std::cos(a), std::sin(a), 0}, left{-std::sin(a), std::cos(a), 0};
  REQUIRE(rows.rows.size() > 20);
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const auto& row = rows.rows[i];
    if (i > 0) CHECK(row.across_mm - rows.rows[i - 1].across_mm == Approx(0.8).margin(1e-9));
    for (const auto& run : row.runs) {
      for (const Vec3& p : run) CHECK(dot(p, left) == Approx(row.across_mm).margin(1e-12));
      // Steep links may step back by their error.
      for (std::size_t k = 1; k < run.size(); ++k)
        CHECK(dot(run[k] - run[k - 1], along) >= -request.cut.tolerance_mm);
    }
  }
}

TEST_CASE("rows over a plane are as far apart as its scallop lets them", "[unit][zigzag]") {
  // Rows p apart across a plane that rises by a along them and by c across: the lines in which the
  // ball touches are p √(1 + c² / (1 + a²)) apart, and h = R - √(R² - (that / 2)²) stands between.
  const double slope = GENERATE(0.0, 1.0, 2.0), angle = GENERATE(0.0, 30.0, 90.0);
  const surface::FinishModel finish(test::bilinear_cage(2, 20, slope, 0, 0), {0.01, 3, 10}, {});
  auto request = ball_request(finish.patches().bounding_box(), angle);
  request.cut.step_mm = 1;
  request.cut.scallop_mm = 0.005;
  const auto rows = make_ball_rows(finish.patches(), request, {});
  const double turn = angle * std::numbers::pi / 180;
  const double a = slope * std::cos(turn), c = slope * std::sin(turn);
  const double apart =
      2 * std::sqrt(9 - std::pow(3 - 0.005, 2)) / std::sqrt(1 + c * c / (1 + a * a));
  int inside = 0;
  for (std::size_t i = 1; i < rows.rows.size(); ++i) {
    const double from = rows.rows[i - 1].across_mm, to = rows.rows[i].across_mm;
    CHECK(to - from <= 1 + 1e-9);
    if (std::abs(from) > 8 || std::abs(to) > 8) continue;
    ++inside;
    CHECK(to - from <= apart * (1 + 1e-6));
    CHECK(to - from >= 0.95 * apart);
  }
  CHECK(inside > 20);
}

TEST_CASE("cusps on curved surfaces are as low as asked", "[property][zigzag]") {
  // Convex: radius of curvature 10 at the top; concave: the same, which the ball of 3 fits into.
  const double bend = GENERATE(-0.05, 0.05);
  const model::Cage cage = test::paraboloid_cage(8, 3, bend);
  // So fine that the tolerance holds all that the model lacks.
  const surface::FinishModel finish(cage, {0.002, 3.1, 10}, {});
  auto request = ball_request(finish.patches().bounding_box(), 90);
  request.cut.step_mm = 2;
  request.cut.scallop_mm = 0.02;
  request.cut.tolerance_mm = 0.002;
  const auto rows = make_ball_rows(finish.patches(), request, {});
  double most = 0;
  const std::vector<Vec3> points = limit_points(cage, 4);
  for (std::size_t i = 0; i < points.size(); i += 19)
    if (std::hypot(points[i].x, points[i].y) < 5)
      most = std::max(most, left_over(rows, points[i], 3));
  CHECK(most <= 0.02 + request.cut.tolerance_mm);
  // No denser than asked for either: a good part of the height is used.
  CHECK(most >= 0.015);
}

TEST_CASE("one-way rows are all cut the same way", "[unit][zigzag]") {
  const surface::FinishModel finish(test::bilinear_cage(2, 10, 0.2, -0.1, 0), {0.01, 3, 10}, {});
  auto request = ball_request(finish.patches().bounding_box(), 0);
  request.cut.pattern = strategy::RowPattern::one_way;
  request.cut.direction =
      GENERATE(strategy::CutDirection::climb, strategy::CutDirection::conventional);
  const bool climb = request.cut.direction == strategy::CutDirection::climb;
  const auto stage = plan_stage(finish, request, {});
  double before = climb ? 1e9 : -1e9;
  int rows = 0;
  for (std::size_t i = 0; i < stage.path.moves.size(); ++i) {
    const Vec3 a = model::move_from(stage.path, i), b = stage.path.moves[i].to;
    // Across the middle of the plate at the height of the ball over it: a cut, not a link.
    if (std::min(a.x, b.x) > 0 || std::max(a.x, b.x) < 0 || a.y != b.y || std::abs(a.y) > 9)
      continue;
    CHECK(b.x > a.x);
    // Climb: what is still to be cut lies on the right.
    CHECK((climb ? a.y < before : a.y > before));
    before = a.y;
    ++rows;
  }
  CHECK(rows > 20);
}

TEST_CASE("gaps within a row are bridged without a gouge", "[property][zigzag]") {
  const model::Cage cage = plates(3);
  const surface::FinishModel finish(cage, {0.01, 3, 8}, {});
  const auto request = ball_request(finish.patches().bounding_box(), 90);
  const auto rows = make_ball_rows(finish.patches(), request, {});
  const auto gapped = std::count_if(rows.rows.begin(), rows.rows.end(),
                                    [](const auto& row) { return row.runs.size() == 2; });
  REQUIRE(gapped > 40);
  const auto stage = plan_stage(finish, request, {});
  const auto found =
      test::probe(stage.path, request.cutter, 0, test::PointBins(limit_points(cage, 5), 1), 0.2);
  CHECK(found.gouge_mm <= request.cut.tolerance_mm);
}
