#include "engine/strategy/rows/sampled_rows.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

#include "tests/engine/coverage_probe.h"
#include "tests/engine/strategy_parts.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::strategy;
using model::Vec3;

namespace {

using Lines = std::vector<std::vector<Vec3>>;

Lines lines_of(const DriveRows& rows) {
  Lines lines;
  for (const DriveRow& row : rows.rows) lines.insert(lines.end(), row.runs.begin(), row.runs.end());
  return lines;
}

/// A level square of two triangles.
LimitLocations level_square(const engine::surface::FinishModel& square, const StageRequest& request,
                            double half) {
  const engine::surface::Grid grid = test::grid_of(2, 2, [=](int u, int v) {
    return Vec3{half * (2 * u - 1), half * (2 * v - 1), 0};
  });
  const model::Box3 part{{-half, -half, 0}, {half, half, 0}};
  const CutterLocations surface({grid}, request.cutter, 0);
  return {surface, {square.patches(), 0.01}, part, 0, -request.cutter.corner_radius_mm};
}

void check_gouges(const std::tuple<std::string, std::string>& what) {
  const auto& [part, cutter] = what;
  INFO(part << " " << cutter);
  test::Setup setup(part, cutter);
  setup.request.cut.angle_deg = 30;
  setup.request.allowance_mm = part == "dome" ? 0.2 : 0;
  setup.limit = limit_locations(setup.finish.patches(), setup.request);
  const Lines lines = lines_of(make_sampled_rows(setup.limit, setup.request, {}));
  const auto found = test::cover(lines, setup.request.cutter, setup.request.allowance_mm,
                                 test::surface_points(setup.cage, 2), setup.limit.surface,
                                 setup.request.cut.tolerance_mm, setup.request.floor_z_mm);
  REQUIRE(lines.size() > 15);
  // The chord error of the mesh is kept away whole; nothing but rounding and
  // limitgauge::engine::kHeightError_mm remains.
  CHECK(found.gouge_mm <= 2e-6);
}

}  // namespace

TEST_CASE("sampled rows never go below the surface", "[property][sampled_rows]") {
  check_gouges(
      GENERATE(table<std::string, std::string>({{"plane", "flat:D=4"},
                                                {"dome", "taper:D=2,r=0.6,angle=12,L=12"},
                                                {"tight bowl", "flat:D=4"},
                                                {"ridge", "bull:D=6,r=1"},
                                                {"ridge", "taper:D=2,r=0.6,angle=12,L=12"}})));
}

TEST_CASE("sampled rows never go below walls and hollows", "[slow][sampled_rows]") {
  check_gouges(GENERATE(table<std::string, std::string>(
      {{"tight bowl", "ball:D=5"}, {"torus", "bull:D=6,r=1"}, {"block", "flat:D=4"}})));
}

TEST_CASE("sampled rows of a ball leave cusps only", "[property][sampled_rows]") {
  const std::string part = GENERATE("plane", "dome", "ridge");
  INFO(part);
  test::Setup setup(part, "ball:D=6");
  const Lines lines = lines_of(make_sampled_rows(setup.limit, setup.request, {}));
  const auto found = test::cover(lines, setup.request.cutter, 0,
                                 test::surface_points(setup.cage, 4), setup.limit.surface,
                                 setup.request.cut.tolerance_mm / 2, setup.request.floor_z_mm);
  REQUIRE(found.reachable > 20);
  // Tips of neighbouring rows are at most step / cos(slope) apart: slopes stay below 51 degrees,
  // and nothing is hollow.
  const double apart = setup.request.cut.step_mm / std::cos(51 * std::numbers::pi / 180);
  // A point counts as reachable where the cutter comes within half a tolerance of it.
  CHECK(found.uncut_mm <= 1.5 * setup.request.cut.tolerance_mm + apart * apart / (8 * 3));
}

TEST_CASE("rows over a level square reach one radius beyond it", "[unit][sampled_rows]") {
  StageRequest request = test::finish_request({{-10, -10, 0}, {10, 10, 0}}, "flat:D=4");
  request.cut.angle_deg = GENERATE(0.0, 90.0, 180.0, 270.0);
  const engine::surface::FinishModel square(test::bilinear_cage(2, 10, 0, 0, 0), {0.01, 0, 8}, {});
  const LimitLocations limit = level_square(square, request, 10);
  const DriveRows made = make_sampled_rows(limit, request, {});
  // 20 mm and a radius at either side, a plane every half millimetre.
  REQUIRE(made.rows.size() == 48);
  for (const DriveRow& row : made.rows) {
    REQUIRE(row.runs.size() == 1);
    for (const Vec3& p : row.runs.front())
      CHECK(std::abs(p.z - track_rule(limit, request).lift_mm) <= 1e-6);
    // Corners are rounded by the cutter; ends are found to 1e-4 mm.
    const double beyond = std::max(0.0, std::abs(row.across_mm) - 10);
    const double reach = 2 * (10 + std::sqrt(4 - beyond * beyond));
    CHECK(std::abs(distance(row.runs.front().front(), row.runs.front().back()) - reach) < 3e-4);
    CHECK(row.runs.front().size() == 2);
  }
}

TEST_CASE("rows follow a tilted plane in one chord where nothing else is near",
          "[unit][sampled_rows]") {
  test::Setup setup("plane", "bull:D=6,r=1");
  const DriveRows made = make_sampled_rows(setup.limit, setup.request, {});
  const Vec3 normal = normalized(Vec3{-0.2, 0.1, 1});
  int chords = 0;
  for (const DriveRow& row : made.rows)
    for (std::size_t i = 1; i < row.runs.front().size(); ++i) {
      const Vec3 &a = row.runs.front()[i - 1], &b = row.runs.front()[i];
      if (distance(a, b) < 10 || std::abs(row.across_mm) > 6) continue;
      ++chords;
      // Centre of the corner's circle over the plane, then the corner radius.
      const double level = std::hypot(normal.x, normal.y);
      const double above = dot((a + b) * 0.5 + Vec3{0, 0, 1}, normal) - 2 * level - 1;
      CHECK(above >= 0);
      CHECK(above <= setup.request.cut.tolerance_mm);
    }
  // Rows are half a millimetre apart: those within 6 mm of the middle are over the plane.
  CHECK(chords >= 23);
}

TEST_CASE("a scallop height brings rows closer where the surface is steep across them",
          "[unit][sampled_rows]") {
  test::Setup setup("dome", "ball:D=6");
  setup.request.cut.step_mm = 2;
  setup.request.cut.scallop_mm = 0.02;
  const DriveRows made = make_sampled_rows(setup.limit, setup.request, {});
  const double apart = 2 * std::sqrt(2 * 3 * 0.02 - 0.02 * 0.02);
  double widest = 0;
  for (std::size_t i = 1; i < made.rows.size(); ++i)
    widest = std::max(widest, made.rows[i].across_mm - made.rows[i - 1].across_mm);
  CHECK(widest <= apart);
  const auto found = test::cover(lines_of(made), setup.request.cutter, 0,
                                 test::surface_points(setup.cage, 4), setup.limit.surface,
                                 setup.request.cut.tolerance_mm / 2, setup.request.floor_z_mm);
  CHECK(found.uncut_mm <= 0.02 + setup.request.cut.tolerance_mm);
  setup.request.cutter = model::parse_cutter("flat:D=6");
  CHECK_THROWS_AS(make_sampled_rows(setup.limit, setup.request, {}), std::invalid_argument);
}

TEST_CASE("sampled rows are the same for any number of threads", "[property][sampled_rows]") {
  const test::Setup setup("block", "bull:D=6,r=1");
  model::RunControl three;
  three.threads = 3;
  CHECK(lines_of(make_sampled_rows(setup.limit, setup.request, {})) ==
        lines_of(make_sampled_rows(setup.limit, setup.request, three)));
}
