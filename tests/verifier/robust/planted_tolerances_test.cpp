// Planes cut by a ball, with a defect that the stated values hide: the worst values make it exceed
// the limit in closed form, or leave it within.
#include <cmath>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/rasters.h"
#include "verifier/gate/verify.h"
#include "verifier/robust/robust_figures.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;

/// Rows a step apart along X over a plane that rises along X, all lifted off it by the same.
struct PlantedPlane {
  double radius_mm, step_mm, slope, lift_mm;
  double zero_x_mm, zero_z_mm, radius_off_mm, length_off_mm;  ///< half widths

  double cosine() const { return 1 / std::sqrt(1 + slope * slope); }
  double sine() const { return slope * cosine(); }
  /// How far towards the plane the worst shift, length and radius bring the ball, or off it, with
  /// the tolerances grown by a factor. A larger ball stands on its tip: its side comes nearer.
  double nearer_mm(double factor) const {
    return factor * (zero_x_mm * std::abs(sine()) + (zero_z_mm + length_off_mm) * cosine() +
                     radius_off_mm * (1 - cosine()));
  }
  double gouge_mm(double factor) const {
    return std::max(0.0, nearer_mm(factor) - lift_mm * cosine());
  }
  double uncut_mm(double factor) const {
    const double radius = radius_mm - factor * radius_off_mm, wide = step_mm / cosine();
    const double scallop = radius - std::sqrt(radius * radius - wide * wide / 4);
    return std::max(0.0, nearer_mm(factor) + lift_mm * cosine() + scallop);
  }
  double figure_mm(Side side, double factor) const {
    return side == Side::uncut ? uncut_mm(factor) : gouge_mm(factor);
  }
};

PlantedPlane drawn_plane(Side side, std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  PlantedPlane out{between(1, 4),    between(0.2, 0.5), between(-0.6, 0.6), between(0.001, 0.006),
                   between(0, 0.01), between(0, 0.01),  between(0, 0.02),   between(0, 0.01)};
  // Something of a gouge is left at the worst values.
  if (side != Side::uncut) out.lift_mm = std::min(out.lift_mm, out.nearer_mm(0.5));
  return out;
}

RobustDeviation measured(const PlantedPlane& plane, Side side, double limit_mm, bool margin) {
  const ReferenceSurface surface(plane_cage(2, plane.slope, 0));
  const double tip = plane.radius_mm / plane.cosine() - plane.radius_mm + plane.lift_mm;
  const std::vector<Pass> passes{
      {ball_cutter(plane.radius_mm), shared(raster(4, plane.step_mm, 4, [&](double x, double) {
         return plane.slope * x + tip;
       }))}};
  StageCheck check;
  check.resolution_mm = limit_mm / 10;
  check.field_spacing_mm = 2;
  check.finds_margin = margin;
  (side == Side::uncut ? check.limits.has_uncut : check.limits.has_gouge) = true;
  (side == Side::uncut ? check.limits.uncut_mm : check.limits.gouge_mm) = limit_mm;
  const auto about = [](double half) { return model::Interval{-half, half}; };
  model::Tolerances tolerances;
  tolerances.zero_mm = {about(plane.zero_x_mm), about(0), about(plane.zero_z_mm)};
  tolerances.tools["ball"] = {about(plane.radius_off_mm), about(plane.length_off_mm), {}, {}};
  check.tolerances = tolerances;
  const model::Stock block = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
  const StageDeviation d = measure_stage(surface, block, passes, nullptr, check, {2});
  const Interval stated = side == Side::uncut ? d.uncut_mm : d.gouge_mm;
  // What is planted is hidden at the stated values.
  CHECK(stated.high <= limit_mm);
  return *d.robust;
}

Verdict verdict_of(const RobustDeviation& robust, Side side, double limit_mm) {
  GateLimits limits;
  (side == Side::uncut ? limits.has_uncut : limits.has_gouge) = true;
  (side == Side::uncut ? limits.uncut_mm : limits.gouge_mm) = limit_mm;
  return judge_robust(robust, limits);
}

/// Where a figure that grows reaches the limit, by halving.
double factor_at(const PlantedPlane& plane, Side side, double limit_mm) {
  double low = 0, high = 100;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (plane.figure_mm(side, middle) > limit_mm ? high : low) = middle;
  }
  return high;
}

}  // namespace

TEST_CASE("what only some values of the tolerances take beyond the limit is found", "[property]") {
  std::mt19937 random(2200);
  for (int k = 0; k < by_effort(40, 200); ++k) {
    const Side side = k % 2 == 0 ? Side::gouge : Side::uncut;
    const PlantedPlane plane = drawn_plane(side, random);
    const double none = plane.figure_mm(side, 0), whole = plane.figure_mm(side, 1);
    const double limit = whole - std::uniform_real_distribution(0.02, 0.5)(random) * (whole - none);
    CAPTURE(k, none, whole, limit);
    const RobustDeviation found = measured(plane, side, limit, false);
    CHECK(verdict_of(found, side, limit) == Verdict::fail);
    const RobustFigure& figure = side == Side::uncut ? found.uncut : found.gouge;
    CHECK(figure.figure_mm.low <= whole + 1e-6);
    CHECK(figure.figure_mm.high >= whole - 1e-6);
  }
}

TEST_CASE("what no value of the tolerances takes beyond the limit does not fail", "[property]") {
  std::mt19937 random(2201);
  for (int k = 0; k < by_effort(20, 100); ++k) {
    const Side side = k % 2 == 0 ? Side::gouge : Side::uncut;
    const PlantedPlane plane = drawn_plane(side, random);
    const double limit =
        plane.figure_mm(side, 1) * std::uniform_real_distribution(1.02, 2.0)(random);
    CAPTURE(k, plane.figure_mm(side, 1), limit);
    CHECK(verdict_of(measured(plane, side, limit, false), side, limit) == Verdict::pass);
  }
}

TEST_CASE("the margin of a planted plane is where its figure reaches the limit", "[property]") {
  std::mt19937 random(2202);
  for (int k = 0; k < by_effort(10, 40); ++k) {
    const Side side = k % 2 == 0 ? Side::gouge : Side::uncut;
    const PlantedPlane plane = drawn_plane(side, random);
    const double none = plane.figure_mm(side, 0), whole = plane.figure_mm(side, 1);
    const double limit = none + std::uniform_real_distribution(0.3, 3.0)(random) * (whole - none);
    CAPTURE(k, none, whole, limit);
    const RobustDeviation found = measured(plane, side, limit, true);
    const RobustFigure& figure = side == Side::uncut ? found.uncut : found.gouge;
    const double factor = factor_at(plane, side, limit);
    REQUIRE(figure.margin);
    REQUIRE(figure.margin->proven);
    REQUIRE(figure.margin->refuted);
    // The search ends at a thousandth; the figures themselves are rounded by some nanometres.
    CHECK(*figure.margin->proven <= factor * (1 + 1e-4));
    CHECK(*figure.margin->proven >= factor * (1 - 1.5e-3));
    CHECK(*figure.margin->refuted >= factor * (1 - 1e-4));
    // Of a cusp that is beyond by some nanometres no witness may be found.
    CHECK(*figure.margin->refuted <= factor * (1 + 1e-2));
  }
}

}  // namespace limitgauge::verifier
