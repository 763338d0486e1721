#include "engine/strategy/levels/waterline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/strategy/levels/height_curves.h"
#include "tests/engine/lift_probe.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using engine::strategy::CutterLocations;
using engine::strategy::Waterline;
using engine::strategy::WaterlineRequest;
using model::Vec3;

namespace {

constexpr double kTolerance = 0.01;

WaterlineRequest request_over(double half, double spacing) {
  return {{{-half, -half, 0}, {half, half, 0}}, spacing, kTolerance};
}

CutterLocations locations(std::vector<test::Grid> grids, const char* cutter) {
  return CutterLocations(std::move(grids), model::parse_cutter(cutter), 0);
}

/// Twice the signed area: positive for a way that runs counter-clockwise.
double turning(const Waterline& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.tips.size(); ++i) {
    const Vec3 &a = line.tips[i], &b = line.tips[(i + 1) % line.tips.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

/// Least and greatest distance of a closed way from the axis through `middle`.
std::pair<double, double> radii(const Waterline& line, const Vec3& middle) {
  double least = 1e9, greatest = 0;
  for (std::size_t i = 0; i < line.tips.size(); ++i) {
    const Vec3 &a = line.tips[i], &b = line.tips[(i + 1) % line.tips.size()];
    for (int k = 0; k < 10; ++k) {
      const Vec3 p = lerp(a, b, k / 10.0) - middle;
      least = std::min(least, std::hypot(p.x, p.y));
      greatest = std::max(greatest, std::hypot(p.x, p.y));
    }
  }
  return {least, greatest};
}

/// A part of a sphere about the origin, facets of two degrees.
test::Grid dome_grid(double radius, double half_angle) {
  return test::grid_of(181, 61, [=](int u, int v) {
    const double a = u % 180 * (2 * std::numbers::pi / 180), b = half_angle * v / 60;
    return Vec3{radius * std::sin(b) * std::cos(a), radius * std::sin(b) * std::sin(a),
                radius * std::cos(b)};
  });
}

bool clear_of(const CutterLocations& surface, const Waterline& line) {
  for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.tips.size(); ++i)
    if (!surface.clears(line.tips[i], line.tips[(i + 1) % line.tips.size()], 0)) return false;
  return true;
}

}  // namespace

TEST_CASE("contours of a ball over a sphere are circles", "[unit][waterline]") {
  const double z = GENERATE(3.0, 5.5, 7.0);
  const CutterLocations surface = locations({dome_grid(8, 1.5)}, "ball:D=4");
  const auto lines = waterlines(surface, {z}, request_over(12, 0.5), {});
  REQUIRE(lines.size() == 1);
  REQUIRE(lines[0].size() == 1);
  REQUIRE(lines[0][0].closed);
  // The ball's centre runs on a sphere of 8 + 2 mm. Facets lie inside by at most
  // 8 (1 - cos 1 degree) = 1.3 um around and 0.7 um up, which a slope of 26 degrees at the highest
  // level makes 5 um in the plane.
  const double exact = std::sqrt(100 - (z + 2) * (z + 2));
  const auto [least, greatest] = radii(lines[0][0], {});
  CHECK(least >= exact - 5e-3);
  CHECK(greatest <= exact + kTolerance);
  CHECK(clear_of(surface, lines[0][0]));
  // The sphere on the right of the way: clockwise around it.
  CHECK(turning(lines[0][0]) < 0);
  // A chord may leave the circle by the tolerance: no more points than a regular polygon needs
  // with a tenth of it.
  CHECK(static_cast<double>(lines[0][0].tips.size()) <
        2 * std::numbers::pi * std::sqrt(exact / (8 * 0.1 * kTolerance)) + 4);
}

TEST_CASE("around a hole contours run the other way", "[unit][waterline]") {
  // A level ring of 4 to 12 mm: a flat cutter of 2 mm radius fits into the hole with 2 mm to spare.
  const test::Grid ring = test::grid_of(181, 2, [](int u, int v) {
    const double a = u % 180 * (2 * std::numbers::pi / 180), r = v == 0 ? 4 : 12;
    return Vec3{r * std::cos(a), r * std::sin(a), 0};
  });
  const auto lines = waterlines(locations({ring}, "flat:D=4"), {-1}, request_over(16, 0.4), {});
  REQUIRE(lines[0].size() == 2);
  const auto inner = turning(lines[0][0]) > 0 ? lines[0][0] : lines[0][1];
  const auto outer = turning(lines[0][0]) > 0 ? lines[0][1] : lines[0][0];
  CHECK(turning(inner) > 0);
  CHECK(turning(outer) < 0);
  // Facets of two degrees: 12 (1 - cos 1 degree) = 1.8 um.
  CHECK(radii(inner, {}).first >= 2 - kTolerance - 1e-3);
  CHECK(radii(inner, {}).second <= 2 + 1e-3);
  CHECK(radii(outer, {}).first >= 14 - 2e-3);
  CHECK(radii(outer, {}).second <= 14 + kTolerance);
}

TEST_CASE("two islands get a contour each", "[unit][waterline]") {
  test::Grid left = dome_grid(3, 1.5), right = left;
  for (Vec3& p : left.points) p.x -= 8;
  for (Vec3& p : right.points) p.x += 8;
  const CutterLocations surface = locations({left, right}, "bull:D=4,r=1");
  const auto lines = waterlines(surface, {1.0, 2.0}, request_over(16, 0.4), {});
  for (const auto& level : lines) {
    REQUIRE(level.size() == 2);
    CHECK(level[0].closed);
    CHECK(level[1].closed);
    CHECK(clear_of(surface, level[0]));
    CHECK(clear_of(surface, level[1]));
  }
}

TEST_CASE("contours of a tilted plane are straight and open", "[unit][waterline]") {
  const test::Grid plane = test::height_grid(4, 40, [](double x, double) { return 0.5 * x; });
  const CutterLocations surface = locations({plane}, "ball:D=6");
  const auto lines = waterlines(surface, {1.0}, request_over(10, 0.7), {});
  REQUIRE(lines[0].size() == 1);
  CHECK_FALSE(lines[0][0].closed);
  // Centre 3 mm along the normal from the plane: z = x / 2 + 3 sqrt(1.25) - 3 at the tip.
  const double exact = 2 * (1 - 3 * std::sqrt(1.25) + 3);
  REQUIRE(lines[0][0].tips.size() == 2);
  for (const Vec3& p : lines[0][0].tips) {
    // The plane rises toward +X: the free side is that of smaller x. Heights are proven to
    // 1e-6 mm and lie 1e-5 mm above the level: 22 nm in x.
    CHECK(p.x <= exact + 3e-5);
    CHECK(p.x >= exact - kTolerance);
  }
  // The rising side on the right: toward +Y.
  CHECK(lines[0][0].tips.back().y > lines[0][0].tips.front().y);
}

TEST_CASE("a level at a plateau meets only what rises above it", "[unit][waterline]") {
  // A step: level at 0 for x < 0, level at 3 for x > 0, an upright wall between.
  const std::vector<test::Grid> step = {
      test::grid_of(2, 2,
                    [](int u, int v) {
                      return Vec3{20.0 * u - 20, 40.0 * v - 20, 0};
                    }),
      test::grid_of(2, 2, [](int u, int v) {
        return Vec3{20.0 * u, 40.0 * v - 20, 3};
      })};
  const CutterLocations surface = locations(step, "flat:D=4");
  const auto lines = waterlines(surface, {0.0, 3.0}, request_over(10, 0.5), {});
  REQUIRE(lines[0].size() == 1);
  for (const Vec3& p : lines[0][0].tips) {
    CHECK(p.x <= -2);
    CHECK(p.x >= -2 - kTolerance);
    CHECK(p.z >= 0);
  }
  CHECK(lines[1].empty());
}

TEST_CASE("a curve beside a plateau takes few looks, however uneven heights are",
          "[slow][waterline]") {
  // A hill of 3 mm on a plateau that is level, or level but for `uneven`; heights of the raster are
  // off by up to a hundredth of a millimetre. The curve runs a fraction of what heights are exact
  // to (1e-6 mm) above the plateau, or within its unevenness: there is no telling which side a
  // place of the plateau is on.
  const double uneven = GENERATE(0.0, 1e-6, 1e-4, 3e-3), above = GENERATE(2e-7, 4e-7, 1e-6);
  INFO(uneven << " " << above);
  const test::Grid hill = test::height_grid(120, 10, [=](double x, double y) {
    const double inside = std::max(0.0, 1 - (x * x + y * y) / 16);
    return 3 * inside * inside + uneven * std::sin(17 * x + 3 * y) * std::sin(23 * y - 5 * x);
  });
  const CutterLocations surface = locations({hill}, "ball:D=4");
  const WaterlineRequest request = request_over(8, 0.15);
  auto tips = make_tip_raster(surface, request.window, request.spacing_mm, {});
  tips.error_mm = 0.01;
  for (std::size_t i = 0; i < tips.z.size(); ++i)
    tips.z[i] += 0.5 * tips.error_mm * (1 + std::sin(1.7 * static_cast<double>(i)));
  engine::strategy::CellMask all(tips.raster), none(tips.raster);
  all.set.assign(all.set.size(), 1);
  const engine::strategy::CurveNeed need{all, 0, none, 0};
  const engine::strategy::UnsureNodes unsure(tips, all);
  const engine::strategy::HeightCurves curves(surface, tips, need, unsure, above, kTolerance);
  // Measured: three looks a node of the raster, or ninety where the plateau is uneven by just what
  // heights are exact to; without an end to the search it is a matter of luck.
  CHECK_FALSE(curves.curves().empty());
  CHECK(curves.looks() <= 200 * tips.z.size());
  // What is made of it is clear of the surface and goes around the hill.
  double length = 0;
  const auto lines = waterlines(surface, tips, need, {above}, kTolerance, {});
  for (const Waterline& line : lines[0]) {
    CHECK(clear_of(surface, line));
    for (std::size_t i = 1; i < line.tips.size(); ++i)
      length += distance(line.tips[i - 1], line.tips[i]);
  }
  // Around the foot at 4 mm a ball of 2 mm keeps away by up to its radius; the window is 16 mm
  // wide.
  CHECK(length >= 2 * std::numbers::pi * 4);
}

TEST_CASE("contours are the same for any number of threads", "[property][waterline]") {
  const CutterLocations surface = locations({test::crumpled_grid(8, 10, 7)}, "bull:D=3,r=0.5");
  model::RunControl three;
  three.threads = 3;
  const std::vector<double> heights = {-1, -0.5, 0, 0.5, 1};
  const auto a = waterlines(surface, heights, request_over(12, 0.3), {});
  const auto b = waterlines(surface, heights, request_over(12, 0.3), three);
  REQUIRE(a.size() == b.size());
  std::size_t curves = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    REQUIRE(a[i].size() == b[i].size());
    curves += a[i].size();
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      CHECK(a[i][k].tips == b[i][k].tips);
      CHECK(clear_of(surface, a[i][k]));
    }
  }
  CHECK(curves > 5);
}
