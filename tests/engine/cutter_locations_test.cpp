#include "engine/strategy/locations/cutter_locations.h"

#include <stdexcept>

#include "model/base/run_control.h"
#include "tests/engine/lift_probe.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using engine::strategy::Assembly;
using engine::strategy::CutterLocations;
using engine::surface::Grid;
using model::Vec3;

namespace {

/// What the interface promises: never below the truth, above it by at most this.
constexpr double kLocationError = limitgauge::engine::kHeightError_mm;

void check_height(double found, double truth, double below = 1e-9) {
  CHECK(found >= truth - below);
  CHECK(found <= truth + kLocationError);
}

CutterLocations locations(std::vector<Grid> grids, const char* cutter, double allowance) {
  return CutterLocations(std::move(grids), model::parse_cutter(cutter), allowance);
}

/// Tip height over the plane z = slope x at x = 0, from the ring of the cutter that touches it.
double on_plane(double ring_radius, double ring_height, double rounding, double slope) {
  return ring_radius * slope + rounding * std::sqrt(1 + slope * slope) - ring_height;
}

Grid edge_grid(const Vec3& a, const Vec3& b) {
  return test::grid_of(2, 2, [&](int u, int) { return u == 0 ? a : b; });
}

}  // namespace

TEST_CASE("tip heights over a tilted plane", "[unit][cutter_locations]") {
  const double slope = GENERATE(0.0, 1e-9, 0.3, 2.0), a = GENERATE(0.0, 0.25);
  const double turn = GENERATE(0.0, 0.7, 2.5);
  const Grid plane = test::height_grid(40, 40, [&](double x, double y) {
    return slope * (x * std::cos(turn) + y * std::sin(turn));
  });
  INFO("slope " << slope << " allowance " << a << " turn " << turn);
  const auto height = [&](const char* cutter) {
    return *locations({plane}, cutter, a).tip_z(0, 0);
  };
  // Rounding of heights up to 80 mm and of tilts keeps 1e-9 mm of room.
  check_height(height("flat:D=8"), on_plane(4, 0, a, slope));
  check_height(height("ball:D=6"), on_plane(0, 3, 3 + a, slope));
  check_height(height("bull:D=8,r=1"), on_plane(3, 1, 1 + a, slope));
  check_height(height("taper:D=2,r=0.5,angle=10,L=9"), on_plane(0.5, 0.5, 0.5 + a, slope));
}

TEST_CASE("a plane steeper than a taper's cone is touched by its widest ring",
          "[unit][cutter_locations]") {
  const double a = GENERATE(0.0, 0.2);
  // A cone of half angle 40 degrees rises by 1.19 a unit outwards: 1.5 is steeper, 1 is not.
  const char* text = "taper:D=2,r=0.5,angle=40,L=4";
  const double widest = model::largest_radius_mm(model::parse_cutter(text));
  const auto height = [&](double slope) {
    const Grid plane = test::height_grid(20, 20, [&](double x, double) { return slope * x; });
    return *locations({plane}, text, a).tip_z(0, 0);
  };
  check_height(height(1), on_plane(0.5, 0.5, 0.5 + a, 1));
  check_height(height(1.5), on_plane(widest, 4, a, 1.5));
  CHECK(on_plane(widest, 4, a, 1.5) > on_plane(0.5, 0.5, 0.5 + a, 1.5));
}

TEST_CASE("tip heights over a single point", "[unit][cutter_locations]") {
  const Vec3 p{1, 2, 5};
  const Grid point = edge_grid(p, p);
  check_height(*locations({point}, "ball:D=6", 0.5).tip_z(1, 2), 5.5);
  check_height(*locations({point}, "ball:D=6", 0.5).tip_z(3, 2), 5 - 3 + std::sqrt(3.5 * 3.5 - 4));
  check_height(*locations({point}, "flat:D=8", 0).tip_z(1, 5.9), 5);
  check_height(*locations({point}, "flat:D=8", 0.5).tip_z(1, 6.3), 5 + 0.4);
  CHECK_FALSE(locations({point}, "flat:D=8", 0).tip_z(1, 6.01).has_value());
}

TEST_CASE("tip heights over an edge", "[unit][cutter_locations]") {
  const double rise = GENERATE(0.0, 0.5, 3.0), aside = GENERATE(0.0, 1.3, 2.9);
  INFO("rise " << rise << " aside " << aside);
  const Grid edge = edge_grid({-50, aside, -50 * rise}, {50, aside, 50 * rise});
  const double root = std::sqrt(1 + rise * rise), a = 0.2;
  check_height(*locations({edge}, "ball:D=6", a).tip_z(0, 0),
               root * std::sqrt(3.2 * 3.2 - aside * aside) - 3);
  check_height(*locations({edge}, "flat:D=6", 0).tip_z(0, 0), rise * std::sqrt(9 - aside * aside));
  if (aside == 0)
    check_height(*locations({edge}, "bull:D=8,r=1", a).tip_z(0, 0), on_plane(3, 1, 1 + a, rise));
}

TEST_CASE("tip heights over a dome", "[unit][cutter_locations]") {
  const double q = 20;
  const Grid dome = test::height_grid(
      120, 12, [&](double x, double y) { return std::sqrt(q * q - x * x - y * y); });
  // Chords of cells of 0.2 mm (0.283 across) sink by at most 0.283² / 8 / 20, and tilt the height
  // by the secant of the slope (at most 35 degrees at 11.4 mm) at most.
  const double sunk = 0.08 / 160 * 1.3;
  for (const double d : {0.0, 0.31, 2.0, 5.5, 7.9}) {
    INFO("distance " << d);
    const double x = d * std::cos(0.4), y = d * std::sin(0.4);
    const double ball = *locations({dome}, "ball:D=6", 0.1).tip_z(x, y);
    CHECK(ball <= std::sqrt(23.1 * 23.1 - d * d) - 3 + kLocationError);
    CHECK(ball >= std::sqrt(23.1 * 23.1 - d * d) - 3 - sunk);
    const double out = std::max(0.0, d - 3), flat = *locations({dome}, "flat:D=6", 0.1).tip_z(x, y);
    CHECK(flat <= std::sqrt(20.1 * 20.1 - out * out) + kLocationError);
    CHECK(flat >= std::sqrt(20.1 * 20.1 - out * out) - sunk);
  }
}

TEST_CASE("an upright wall is kept clear of", "[unit][cutter_locations]") {
  const Grid wall = test::grid_of(5, 9, [](int u, int v) { return Vec3{0, 4.0 * u - 8, 1.0 * v}; });
  const auto flat = locations({wall}, "flat:D=8", 0), bull = locations({wall}, "bull:D=8,r=1", 0.5);
  check_height(*flat.tip_z(-3.999, 0), 8);
  check_height(*flat.tip_z(-4, 0), 8);
  CHECK_FALSE(flat.tip_z(-4.001, 0).has_value());
  check_height(*bull.tip_z(-4, 0), 8 - 1 + std::sqrt(1.5 * 1.5 - 1));
  CHECK_FALSE(bull.tip_z(-4.501, 0).has_value());
  check_height(*flat.lift({-4, -3, 2}, {-4, 3, 2}), 6);
  CHECK_FALSE(flat.lift({-4.001, -3, 2}, {-4.001, 3, 2}).has_value());
  CHECK(flat.clears({-4.001, -3, 2}, {-4.001, 3, 2}, 0));
  CHECK_FALSE(flat.clears({-4.1, 0, 2}, {-3.9, 0, 2}, 1));
}

TEST_CASE("shank and holder keep clear too", "[unit][cutter_locations]") {
  // A pillar 30 mm high beside the flutes: the holder's part that is wider than all below it.
  const Grid pillar = edge_grid({8, 0, 30}, {9, 0, 30});
  const auto cutter = model::parse_cutter("flat:D=6,L=10,shank=5:8,holder=18:20,holder=12:5");
  const CutterLocations whole({pillar}, cutter, 0.5),
      flutes({pillar}, cutter, 0.5, Assembly::flutes);
  CHECK_FALSE(flutes.tip_z(0, 0).has_value());
  check_height(*whole.tip_z(0, 0), 30 - 18 + 0.5);
  check_height(*whole.lift({0, -20, 0}, {0, 20, 0}), 30 - 18 + 0.5);
  CHECK(whole.extent().low.x == Approx(8 - 9.5));
  CHECK(whole.fluted_extent().low.x == Approx(8 - 3.5));
  CHECK(whole.extent().high.z >= 30.5);
}

TEST_CASE("cutters and allowances that are none are refused", "[unit][cutter_locations]") {
  model::Cutter none;
  CHECK_THROWS_AS(CutterLocations({}, none, 0), std::invalid_argument);
  CHECK_THROWS_AS(locations({}, "ball:D=6", -0.1), std::invalid_argument);
  CHECK_FALSE(locations({}, "ball:D=6", 0).tip_z(0, 0).has_value());
  CHECK(locations({}, "ball:D=6", 0).clears({}, {1, 1, 1}, 0));
  CHECK(locations({}, "ball:D=6", 0).extent().empty());
}
