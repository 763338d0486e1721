#include "engine/strategy/levels/steep_shallow.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "engine/strategy/levels/curve_need.h"
#include "engine/strategy/levels/level_choice.h"
#include "engine/strategy/linking/pass_clip.h"
#include "engine/strategy/rows/boundary_pass.h"
#include "engine/strategy/strategies.h"
#include "tests/engine/coverage_probe.h"
#include "tests/engine/strategy_parts.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::strategy;
using model::Vec3;

namespace {

using Lines = std::vector<std::vector<Vec3>>;

SteepShallowPasses passes_of(const test::Setup& setup) {
  return steep_shallow_passes(setup.finish.patches(), setup.limit, setup.request, {});
}

Lines contours_of(const SteepShallowPasses& made) {
  Lines lines;
  for (const auto& level : made.levels)
    for (auto& line : test::lines_of(level)) lines.push_back(std::move(line));
  return lines;
}

Lines all_of(const SteepShallowPasses& made) {
  Lines lines = contours_of(made);
  for (auto& line : test::lines_of(made.rows)) lines.push_back(std::move(line));
  return lines;
}

test::Coverage cover(const test::Setup& setup, const Lines& lines, int depth) {
  return test::cover(lines, setup.request.cutter, setup.request.allowance_mm,
                     test::surface_points(setup.cage, depth), setup.limit.surface,
                     setup.request.cut.tolerance_mm / 2, setup.request.floor_z_mm);
}

void check_split_gouges(const std::tuple<std::string, std::string>& what) {
  const auto& [part, cutter] = what;
  INFO(part << " " << cutter);
  const test::Setup setup(part, cutter);
  const auto found = cover(setup, all_of(passes_of(setup)), 2);
  // As for rows: all of the mesh's error is kept away.
  CHECK(found.gouge_mm <= 2e-6);
}

/// A row of cells of 1 mm over heights that are given.
SlopeCells strip(const std::vector<double>& heights) {
  TipRaster tips;
  tips.raster = {0, 0, 1, static_cast<int>(heights.size()), 2};
  tips.z = heights;
  tips.z.insert(tips.z.end(), heights.begin(), heights.end());
  return measure_slopes(tips, -100);
}

}  // namespace

TEST_CASE("steep and shallow passes never go below the surface", "[property][steep_shallow]") {
  check_split_gouges(GENERATE(table<std::string, std::string>({{"dome", "flat:D=4"},
                                                               {"tight bowl", "ball:D=5"},
                                                               {"tight bowl", "bull:D=6,r=1"},
                                                               {"ridge", "flat:D=4"},
                                                               {"ridge", "ball:D=5"}})));
}

TEST_CASE("steep and shallow passes never go below closed parts", "[slow][steep_shallow]") {
  check_split_gouges(
      GENERATE(table<std::string, std::string>({{"cube", "taper:D=2,r=0.6,angle=12,L=12"},

                                                {"block", "bull:D=6,r=1"},
                                                {"block", "taper:D=2,r=0.6,angle=12,L=12"}})));
}

TEST_CASE("a ball leaves cusps only, on flats and walls", "[slow][steep_shallow]") {
  const std::string part = GENERATE("dome", "cube", "torus", "ridge", "block");
  INFO(part);
  const test::Setup setup(part, "ball:D=6");
  const auto found = cover(setup, all_of(passes_of(setup)), 3);
  REQUIRE(found.reachable > 100);
  INFO("left at " << found.left.p.x << " " << found.left.p.y << " " << found.left.p.z);
  // Rows up to 45 degrees: tips at most step / cos 45 apart; contours: at most a step. On convex
  // surfaces the cusp is at most apart² / (8 r); twice that where the torus is hollow.
  const double apart = setup.request.cut.step_mm * std::numbers::sqrt2;
  // A point counts as reachable where the cutter comes within half a tolerance of it.
  CHECK(found.gouge_mm <= 2e-6);
  CHECK(found.uncut_mm <= 1.5 * setup.request.cut.tolerance_mm + apart * apart / (4 * 3));
}

TEST_CASE("regions overlap at the seam only", "[property][steep_shallow]") {
  test::Setup setup("block", "ball:D=3");
  setup.request.cut.overlap_mm = 0.6;
  const SteepShallowPasses made = passes_of(setup);
  REQUIRE(made.levels.size() > 4);
  REQUIRE(made.rows.size() > 10);
  const model::Box3 part = setup.finish.patches().bounding_box();
  // Rows go down the walls, and contours onto the top, no farther than the overlap and a cell
  // (three tenths of a millimetre) beyond where the rounded edge passes 45 degrees: at most the
  // edge's rounding of 1.5 mm and the cutter's own inwards.
  for (const auto& row : made.rows)
    for (const Vec3& p : row.tips) CHECK(p.z > part.high.z - 1.5 - 1.5 - 0.6);
  for (const auto& line : contours_of(made))
    for (const Vec3& p : line)
      CHECK(std::max(std::abs(p.x), std::abs(p.y)) > part.high.x - 1.5 - 0.6 - 0.4);
  // From the top down.
  for (std::size_t i = 1; i < made.levels.size(); ++i)
    CHECK(made.levels[i].front().tips.front().z < made.levels[i - 1].front().tips.front().z);
}

TEST_CASE("a gentle part has no contours, a wall no rows", "[unit][steep_shallow]") {
  const test::Setup plane("plane", "flat:D=4");
  CHECK(passes_of(plane).levels.empty());
  test::Setup ridge("ridge", "ball:D=3");
  ridge.request.cut.steep_angle_deg = 40;  // both sides slope by 50 degrees
  const SteepShallowPasses made = passes_of(ridge);
  CHECK(test::length_of(contours_of(made)) > 3 * test::length_of(test::lines_of(made.rows)));
}

TEST_CASE("contours climb unless asked otherwise", "[unit][steep_shallow]") {
  test::Setup setup("cube", "ball:D=4");
  setup.request.cut.step_mm = 1;
  const CutDirection direction =
      GENERATE(CutDirection::either, CutDirection::climb, CutDirection::conventional);
  setup.request.cut.direction = direction;
  const SteepShallowPasses made = passes_of(setup);
  int closed = 0;
  for (const auto& level : made.levels)
    for (const CutPass& pass : level) {
      CHECK(pass.reversible == (direction == CutDirection::either));
      if (!pass.closed) continue;
      ++closed;
      double turning = 0;
      for (std::size_t i = 0; i < pass.tips.size(); ++i) {
        const Vec3 &a = pass.tips[i], &b = pass.tips[(i + 1) % pass.tips.size()];
        turning += a.x * b.y - a.y * b.x;
      }
      // The part on the right: clockwise around it.
      CHECK((turning < 0) == (direction != CutDirection::conventional));
    }
  CHECK(closed > 5);
}

TEST_CASE("heights from sections of a ball's offset surface are the exact ones within their error",
          "[property][tip_raster]") {
  const test::Setup setup(GENERATE("dome", "ridge", "torus"), "ball:D=4");
  const double cell = 0.25;
  const model::Box3 window = setup.limit.surface.fluted_extent().grown(cell);
  const TipRaster exact = make_tip_raster(setup.limit.surface, window, cell, {});
  const TipRaster made = make_ball_raster(setup.finish.patches(), setup.request, window, cell, {});
  REQUIRE(made.z.size() == exact.z.size());
  int compared = 0;
  for (std::size_t i = 0; i < made.z.size(); ++i) {
    if (!std::isfinite(made.z[i]) || !std::isfinite(exact.z[i])) continue;
    const int column = static_cast<int>(i) % made.raster.columns;
    const int row = static_cast<int>(i) / made.raster.columns;
    // Heights may differ by the error along the normal; where it is steep that is more.
    const auto near = [&](double x, double y) {
      return setup.limit.surface.tip_z(made.raster.x(column) + x, made.raster.y(row) + y)
          .value_or(-1e9);
    };
    const double e = made.error_mm;
    const double highest = std::max({near(e, 0), near(-e, 0), near(0, e), near(0, -e)});
    const double lowest = std::min({near(e, 0), near(-e, 0), near(0, e), near(0, -e)});
    CHECK(made.z[i] <= std::max(highest, exact.z[i]) + e);
    CHECK(made.z[i] >= std::min(lowest, exact.z[i]) - e);
    ++compared;
  }
  CHECK(compared > 100);
}

TEST_CASE("of a curve only what is wanted and short gaps are followed", "[unit][curve_need]") {
  // A ring of radius 4 about the middle of 10 x 10 cells of 1 mm; wanted left of x = 3.
  const Raster raster{0, 0, 1, 11, 11};
  Isoline ring{{}, true};
  for (int k = 0; k <= 72; ++k) {
    const double a = 2 * std::numbers::pi * (k % 72) / 72;
    ring.points.push_back({5 + 4 * std::cos(a), 5 + 4 * std::sin(a)});
  }
  const CellMask none(raster);
  CellMask left(raster);
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 3; ++i) left.set[left.index(i, j)] = 1;
  const auto open = needed_stretches(ring, {left, 0, none, 0});
  REQUIRE(open.size() == 1);
  CHECK_FALSE(open[0].closed);
  for (const FlatPoint& p : open[0].points) CHECK(p.x < 3.5);
  CHECK(open[0].points.size() > 20);
  // The gap is 17 mm long: filled where so much is bridged, and the ring is whole.
  const auto whole_ring = needed_stretches(ring, {left, 9, none, 0});
  REQUIRE(whole_ring.size() == 1);
  CHECK(whole_ring[0].closed);
  CHECK(whole_ring[0].points.size() == ring.points.size());
  CHECK(needed_stretches(ring, {none, 9, none, 0}).empty());
  // Not where other passes touch all of the gap, but for twice what may be cut again and a few
  // cells.
  CellMask all(raster);
  all.set.assign(all.set.size(), 1);
  CHECK_FALSE(needed_stretches(ring, {left, 9, all, 2})[0].closed);
  CHECK(needed_stretches(ring, {left, 9, all, 5})[0].closed);
  const CellMask wider = widened(left, 2);
  CHECK(wider.at(4.5, 5));
  CHECK_FALSE(wider.at(5.5, 5));
}

TEST_CASE("levels are a step apart along the steepest-cut surface", "[unit][levels]") {
  // 60 degrees from 0 to 17.3 mm.
  std::vector<double> heights;
  for (int i = 0; i <= 10; ++i) heights.push_back(i * std::sqrt(3.0));
  const SlopeCells slopes = strip(heights);
  const double angle = std::numbers::pi / 4;
  const CellMask steep = steep_cells(slopes, angle);
  const auto levels = choose_levels(slopes, steep, steep, {1.0, 2.0});
  REQUIRE(levels.size() > 10);
  // Not below the lowest place, and that one too.
  CHECK(levels.back() == 2.0);
  CHECK(levels.front() < heights.back());
  for (std::size_t i = 1; i < levels.size(); ++i)
    CHECK(levels[i - 1] - levels[i] <= std::sqrt(0.75) + 1e-12);
}

TEST_CASE("a wall is cut down to its foot", "[unit][levels]") {
  const SlopeCells slopes = strip({5, 5, 5, 5, 1.3, 1.3, 1.3, 0, 0, 0});
  const CellMask steep = steep_cells(slopes, std::numbers::pi / 4);
  const CellMask cut = grown(steep, slopes, 1.5);
  const auto levels = choose_levels(slopes, cut, steep, {0.7, 0.0});
  CHECK(std::count(levels.begin(), levels.end(), 1.3) == 1);
  CHECK(std::count(levels.begin(), levels.end(), 0.0) == 1);
}

TEST_CASE("growth goes along the surface, not through walls", "[unit][slope_mask]") {
  const SlopeCells slopes = strip({5, 5, 5, 5, 5, 0, 0, 0, 0, 0});
  CellMask top(slopes.nodes);
  top.set[0] = 1;
  const CellMask near = grown(top, slopes, 3);
  CHECK(near.set[3] == 1);
  CHECK(near.set[5] == 0);
  // Four cells to the wall's, down the wall, one more.
  const CellMask far = grown(top, slopes, 4 + std::hypot(1, 5) + 1.1);
  CHECK(far.set[6] == 1);
  CHECK(far.set[7] == 0);
}

TEST_CASE("rows stop on a wall at the overlap from head and foot", "[unit][pass_clip]") {
  CellMask all(Raster{-10, -10, 0.5, 41, 41});
  std::fill(all.set.begin(), all.set.end(), 1);
  const std::vector<Vec3> row = {{-5, 0, 8}, {0, 0, 8}, {0, 0, 0}, {5, 0, 0}};
  const auto kept = clip_row(row, all, {all, 1.0, 1.0}, {std::numbers::pi / 4, 1.0});
  REQUIRE(kept.size() == 2);
  // Cut up in pieces of at most half a cell: 0.25 mm.
  CHECK(std::abs(kept[0].tips.back().z - 7) <= 0.25);
  CHECK(std::abs(kept[1].tips.front().z - 1) <= 0.25);
  CHECK(kept[0].tips.front() == row.front());
  CHECK(kept[1].tips.back() == row.back());
}

TEST_CASE("a closed pass is opened only where it is not wanted", "[unit][pass_clip]") {
  CellMask wanted(Raster{-10, -10, 0.5, 41, 41});
  std::fill(wanted.set.begin(), wanted.set.end(), 1);
  const std::vector<Vec3> square = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
  const auto whole = clip_to(square, true, wanted, {wanted, 0, 0});
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].closed);
  CHECK(whole[0].tips == square);
  for (int j = 0; j < wanted.rows(); ++j)
    for (int i = wanted.columns() / 2; i < wanted.columns(); ++i)
      wanted.set[wanted.index(i, j)] = 0;
  const auto half = clip_to(square, true, wanted, {wanted, 0, 0});
  REQUIRE(half.size() == 1);
  CHECK_FALSE(half[0].closed);
  // From (0, 4) round to (0, -4): two halves of a side and a whole one.
  CHECK(std::abs(test::length_of({half[0].tips}) - 16) <= 0.5);
}

TEST_CASE("gaps are bridged where nothing else cuts, and where they are short",
          "[unit][pass_clip]") {
  CellMask wanted(Raster{-10, -10, 0.5, 41, 41}), all(wanted), none(wanted);
  std::fill(all.set.begin(), all.set.end(), 1);
  wanted = all;
  // A gap of 3 mm: 0 to 3 in x.
  for (int j = 0; j < wanted.rows(); ++j)
    for (int i = 20; i < 26; ++i) wanted.set[wanted.index(i, j)] = 0;
  const std::vector<Vec3> line = {{-5, 0.1, 0}, {5, 0.1, 0}};
  CHECK(clip_to(line, false, wanted, {all, 1, 5}).size() == 2);
  CHECK(clip_to(line, false, wanted, {all, 4, 5}).size() == 1);
  CHECK(clip_to(line, false, wanted, {none, 1, 5}).size() == 1);
  CHECK(clip_to(line, false, wanted, {none, 1, 2}).size() == 2);
  // Around a square too, wherever its gap lies.
  const std::vector<Vec3> square = {{1, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}, {-4, -4, 0}};
  const auto whole = clip_to(square, true, wanted, {none, 1, 5});
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].closed);
  CHECK(whole[0].tips == square);
}

TEST_CASE("the boundary pass follows the rim of an open surface", "[unit][boundary_pass]") {
  const test::Setup setup("plane", "ball:D=6");
  const auto passes = boundary_passes(setup.limit, setup.request, {});
  REQUIRE(passes.size() == 1);
  CHECK(passes[0].closed);
  // The square's outline, at the height of a ball over the plane.
  const Vec3 normal = normalized(Vec3{-0.2, 0.1, 1});
  const Lines lines = test::lines_of(passes);
  for (const Vec3& p : lines[0]) {
    CHECK(std::abs(std::max(std::abs(p.x), std::abs(p.y)) - 10) <= 1e-9);
    // Where the plane ends uphill the ball rolls over its rim: as low as the slope's cosine.
    CHECK(dot(p + Vec3{0, 0, 3}, normal) >= 3 * normal.z);
    CHECK(dot(p + Vec3{0, 0, 3}, normal) <= 3 + setup.request.cut.tolerance_mm);
  }
  double round = 0;
  for (std::size_t i = 1; i < lines[0].size(); ++i)
    round += std::hypot(lines[0][i].x - lines[0][i - 1].x, lines[0][i].y - lines[0][i - 1].y);
  CHECK(std::abs(round - 80) <= 1e-6);
}

TEST_CASE("the boundary pass of a closed part goes around its outline", "[unit][boundary_pass]") {
  const test::Setup setup("torus", "ball:D=4");
  const auto passes = boundary_passes(setup.limit, setup.request, {});
  // Around the ring, and in its hole.
  REQUIRE(passes.size() == 2);
  const model::Box3 part = setup.finish.patches().bounding_box();
  double widest = 0;
  for (const auto& line : test::lines_of(passes))
    for (const Vec3& p : line) {
      CHECK(p.z < part.low.z - 1.9);
      widest = std::max(widest, p.x);
    }
  CHECK(widest >= part.high.x + 2);
  CHECK(widest <= part.high.x + 2 + 2 * setup.request.cut.tolerance_mm);
}

TEST_CASE("a planned stage neither gouges nor rapids below the stock between its passes",
          "[property][steep_shallow][sampled_rows]") {
  const auto [part, cutter, strategy] = GENERATE(table<std::string, std::string, Strategy>(
      {{"ridge", "ball:D=5", Strategy::steep_shallow},
       {"dome", "bull:D=6,r=1", Strategy::steep_shallow},
       {"ridge", "taper:D=2,r=0.6,angle=12,L=12", Strategy::zigzag},
       {"plane", "flat:D=4", Strategy::zigzag}}));
  INFO(part << " " << cutter);
  test::Setup setup(part, cutter);
  setup.request.cut.strategy = strategy;
  setup.request.cut.boundary_pass = true;
  const StagePath stage = plan_stage(setup.finish, setup.request, {});
  CHECK(stage.planes > 10);
  Lines cuts;
  for (std::size_t i = 0; i < stage.path.moves.size(); ++i) {
    const model::Move& move = stage.path.moves[i];
    const Vec3 from = model::move_from(stage.path, i);
    CHECK(move.to.z >= setup.request.floor_z_mm);
    if (move.kind == model::MoveKind::feed) cuts.push_back({from, move.to});
    // Rapids touch nothing either.
    CHECK((move.kind == model::MoveKind::feed || setup.limit.surface.clears(from, move.to, 0)));
  }
  REQUIRE(cuts.size() > 100);
  CHECK(cover(setup, cuts, 2).gouge_mm <= 2e-6);
}

TEST_CASE("steep and shallow refuses what makes no sense", "[unit][steep_shallow]") {
  test::Setup setup("plane", "ball:D=4");
  setup.request.cut.steep_angle_deg = 90;
  CHECK_THROWS_AS(passes_of(setup), std::invalid_argument);
  setup.request.cut.steep_angle_deg = 45;
  setup.request.cut.overlap_mm = -1;
  CHECK_THROWS_AS(passes_of(setup), std::invalid_argument);
}
