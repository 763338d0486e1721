#include "verifier/certificate/unavoidable.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;

struct Setting {
  double allowance_mm = 0, contact_mm = 1e-3, cell_mm = 1, rim_mm = 0.1;
};

Unavoidable measured(const model::Cage& cage, const model::Cutter& cutter, const Setting& set,
                     const UnavoidableOptions& options, unsigned threads = 2) {
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), set.cell_mm);
  const Reachability reach(cells, CutterProfile(cutter), set.allowance_mm, set.contact_mm);
  const ReachMap map = classify_reach(cells, reach, {set.rim_mm, 50'000}, {threads});
  return unavoidable_uncut(cells, map, reach, {}, cutter, options, {threads});
}

constexpr double kBend = 0.05, kRadius = 12;

/// The interval brackets the closed form, but for what the contact tolerance lets the cutter sink,
/// and is as narrow as was asked for.
void check_interval(const Unavoidable& u, double left_mm, double sunk_mm,
                    const UnavoidableOptions& options) {
  INFO("[" << u.uncut_mm.low << ", " << u.uncut_mm.high << "] of " << left_mm << ", sunk "
           << sunk_mm << "; cells " << u.cells << " points " << u.points << " squares "
           << u.squares);
  CHECK(u.uncut_mm.low <= left_mm);
  CHECK(u.uncut_mm.high >= left_mm - sunk_mm);
  CHECK(u.uncut_mm.width() <= std::max(options.resolution_mm, options.share * u.uncut_mm.high));
  CHECK(u.reached_resolution);
}

}  // namespace

/// At the axis of z = k·r² a ball resting on the circle r₀² = R² − 1/(4k²) leaves (2kR − 1)²/(4k),
/// and along a trough z = k·x² the same. With an allowance a the ball rests as one of R + a does. A
/// contact tolerance c lets it rest as a ball of R + a − c does, whose centre is lower by 2kR·c.
TEST_CASE("unavoidable uncut of a ball in a bowl is bracketed", "[property]") {
  const double left = std::pow(2 * kBend * kRadius - 1, 2) / (4 * kBend);
  const UnavoidableOptions options;
  for (const double allowance : {0.0, 0.5}) {
    const Setting set{allowance, 1e-4, 2, 0.5};
    const Unavoidable u =
        measured(paraboloid_cage(14, kBend), ball_cutter(kRadius - allowance), set, options);
    check_interval(u, left, 2 * kBend * kRadius * set.contact_mm, options);
    REQUIRE(u.place);
    // On the axis, and the value falls with the square of the distance from it: 2 % of 0.2 mm lie
    // within sqrt(0.02 · 0.2 / 0.02) mm, since (|s − C| − R) has the bend 2k − 1/|s − C| there.
    CHECK(std::hypot(u.place->point.x, u.place->point.y) < 0.7);
  }
}

TEST_CASE("unavoidable uncut of a ball in a trough is bracketed", "[property]") {
  const double left = std::pow(2 * kBend * kRadius - 1, 2) / (4 * kBend);
  const auto cage = trough_cage(20, kBend);
  const UnavoidableOptions options;
  const Setting set{0, 1e-4, 1, 0.2};
  const Unavoidable u = measured(cage, ball_cutter(kRadius), set, options);
  check_interval(u, left, 2 * kBend * kRadius * set.contact_mm, options);
  REQUIRE(u.place);
  CHECK(std::abs(u.place->point.x) < 0.7);
}

/// A groove z = m·|x|, rounded by the spline for |x| < h, so that its bottom is at m·h/3. The
/// rounding of a cutter, centred on the circle of radius F at the height r over the tip, rests at
/// the distance r + a from both sides: tip = m·F − r + (r + a)·sqrt(1 + m²), and a flat bottom
/// leaves tip − m·h/3 − a.
TEST_CASE("unavoidable uncut of flat, bull and taper cutters in a groove is bracketed",
          "[property]") {
  constexpr double m = 0.8, h = 2;
  const auto cage = profile_cage(8, 8, [](double x) { return m * std::abs(x); });
  const model::Cutter flat = flat_cutter(3);
  const model::Cutter bull{"bull", model::CutterType::bull, 6, 1, 0, 60, {}, {}};
  const model::Cutter taper{"taper", model::CutterType::taper, 6, 1, 5, 60, {}, {}};
  UnavoidableOptions options;
  for (const auto& cutter : {flat, bull, taper}) {
    const double allowance = cutter.type == model::CutterType::flat ? 0 : 0.2;
    const Setting set{allowance, 1e-4, 0.5, 0.3};
    const double r = cutter.corner_radius_mm, lean = std::sqrt(1 + m * m);
    const double left = m * (3 - r) - r + (r + allowance) * lean - m * h / 3 - allowance;
    const Unavoidable u = measured(cage, cutter, set, options);
    check_interval(u, left, lean * set.contact_mm, options);
  }
}

TEST_CASE("nothing is unavoidable where the cutter reaches everything", "[property]") {
  UnavoidableOptions options;
  options.resolution_mm = 0.02;
  const Setting set{0, 1e-3, 2, 0.5};
  const Unavoidable u = measured(paraboloid_cage(14, kBend), ball_cutter(4), set, options);
  CHECK(u.uncut_mm.low == 0);
  CHECK(u.uncut_mm.high <= options.resolution_mm);
  CHECK(u.reached_resolution);
}

TEST_CASE("unavoidable uncut does not depend on threads and stays valid where effort ends",
          "[property]") {
  const auto cage = star_cage(5, 4);
  const Setting set{0.2, 1e-3, 1, 0.5};
  UnavoidableOptions options;
  options.resolution_mm = 0.05;
  const Unavoidable one = measured(cage, ball_cutter(25), set, options, 1),
                    three = measured(cage, ball_cutter(25), set, options, 3);
  CHECK(one.uncut_mm.low == three.uncut_mm.low);
  CHECK(one.uncut_mm.high == three.uncut_mm.high);
  CHECK(one.cells == three.cells);
  CHECK(one.reached_resolution);
  CHECK(one.uncut_mm.low > 0);
  options.largest_cell_count = 100, options.largest_point_count = 5;
  options.largest_square_count = 50;
  const Unavoidable hasty = measured(cage, ball_cutter(25), set, options, 2);
  CHECK_FALSE(hasty.reached_resolution);
  CHECK(hasty.uncut_mm.low <= one.uncut_mm.high);
  CHECK(hasty.uncut_mm.high >= one.uncut_mm.low);
}

}  // namespace limitgauge::verifier
