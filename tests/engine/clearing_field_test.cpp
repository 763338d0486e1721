#include "engine/strategy/raster/clearing_field.h"

#include <random>

#include "engine/strategy/raster/clip.h"
#include "engine/strategy/raster/distance_field.h"
#include "engine/strategy/raster/swept_raster.h"
#include "tests/engine/cutter_outline.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::strategy;

TEST_CASE("a stack of discs holds the cutter grown by its allowance", "[property][contour]") {
  const std::string text = GENERATE("flat:D=8,L=10", "ball:D=6,L=10", "bull:D=8,r=1,L=10",
                                    "taper:D=2,r=1,angle=5,L=15", "taper:D=3,r=0.2,angle=20,L=12");
  const double allowance = GENERATE(0.0, 0.3);
  INFO(text);
  const model::Cutter cutter = model::parse_cutter(text);
  const std::vector<Disc> discs = disc_stack(cutter, allowance, 0.2);
  const test::CutterOutline outline(cutter);
  for (std::size_t k = 1; k < discs.size(); ++k) {
    CHECK(discs[k].height_mm > discs[k - 1].height_mm);
    CHECK(discs[k].radius_mm > discs[k - 1].radius_mm);
  }
  double loosest = 0;
  for (double h = -allowance - 0.1; h < 20; h += 0.05) {
    double held = 0;
    for (const Disc& disc : discs)
      if (h >= disc.height_mm) held = disc.radius_mm;
    // Just outside the discs no place is nearer to the cutter than the allowance.
    const double away = outline.distance_mm(held, h);
    CHECK(away >= allowance - 1e-9);
    loosest = std::max(loosest, away - allowance);
  }
  // And they are not much too large: steps of 0.2 mm along the rounding, or a twelfth of it.
  CHECK(loosest < 0.6);
}

TEST_CASE("a profile's radius is the outline's", "[unit][contour]") {
  const std::string text = GENERATE("flat:D=8,L=10", "ball:D=6,L=10", "bull:D=8,r=1,L=10",
                                    "taper:D=2,r=1,angle=5,L=15", "taper:D=3,r=0.2,angle=20,L=12");
  const model::Cutter cutter = model::parse_cutter(text);
  const test::CutterOutline outline(cutter);
  for (double h = 0.05; h < 9; h += 0.31)
    CHECK(std::abs(outline.distance_mm(profile_radius_mm(cutter, h), h)) <= 1e-9);
}

TEST_CASE("near distances are the exact ones as far as they reach", "[property][contour]") {
  std::mt19937 random(7);
  const Raster raster{1, 2, 0.25, 71, 53};
  const std::size_t pixels = GENERATE(0, 1, 5, 400, 3000);
  std::vector<float> heights(raster.size(), 0);
  for (std::size_t k = 0; k < pixels; ++k) heights[random() % heights.size()] = 2;
  std::vector<std::uint8_t> set(heights.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = heights[i] > 1;
  const std::vector<float> exact = distance_field(raster, set);
  constexpr double kReach = 3;
  NearDistances near(raster, kReach);
  for (int again = 0; again < 2; ++again) {
    const std::vector<float>& found = near.to_above(heights.data(), raster.columns, 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      REQUIRE(found[i] == Approx(std::min(exact[i], static_cast<float>(kReach))).margin(1e-5));
  }
}

TEST_CASE("a moved disc sweeps the pixels within its radius of the way", "[property][contour]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2, 12);
  const Raster raster{0, 0, 0.3, 40, 35};
  for (int n = 0; n < 60; ++n) {
    SweptRaster swept(raster, std::vector<std::uint8_t>(raster.size(), 0));
    const FlatPoint a{place(random), place(random)};
    FlatPoint b{place(random), place(random)};
    if (n % 5 == 0) b = a;
    if (n % 5 == 1) b.x = a.x;
    if (n % 5 == 2) b.y = a.y;
    const double radius = 0.5 + 0.05 * n;
    swept.sweep(a, b, radius);
    CHECK(swept.is_swept(a, b, radius));
    for (int j = 0; j < raster.rows; ++j)
      for (int i = 0; i < raster.columns; ++i) {
        const double x = raster.x(i), y = raster.y(j);
        const double dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy;
        const double t =
            l2 > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / l2, 0.0, 1.0) : 0.0;
        const double d = std::hypot(x - a.x - t * dx, y - a.y - t * dy);
        if (std::abs(d - radius) < 1e-9) continue;
        REQUIRE((swept.flags()[static_cast<std::size_t>(j) * 40 + i] == 1) == (d < radius));
      }
  }
}

TEST_CASE("a polyline is clipped where it leaves a region", "[unit]") {
  const std::vector<FlatPoint> line = {{-3, 0}, {3, 0}, {3, 1}, {-3, 1}, {0, 1}};
  const auto at = [](const FlatPoint& a, const FlatPoint& b, double t) {
    return FlatPoint{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
  };
  const auto runs = clipped(
      line, 0.5, [](const FlatPoint& p) { return std::abs(p.x) <= 1; }, at,
      [](const FlatPoint& a, const FlatPoint& b) { return distance(a, b); });
  REQUIRE(runs.size() == 3);
  CHECK(runs[0].front().x == Approx(-1).margin(1e-5));
  CHECK(runs[0].back().x == Approx(1).margin(1e-5));
  CHECK(runs[1].front().x == Approx(1).margin(1e-5));
  CHECK(runs[1].back().x == Approx(-1).margin(1e-5));
  CHECK(runs[2].front().x == Approx(-1).margin(1e-5));
  CHECK(runs[2].back().x == 0);
  for (const auto& run : runs)
    for (const FlatPoint& p : run) CHECK(std::abs(p.x) <= 1);
}
