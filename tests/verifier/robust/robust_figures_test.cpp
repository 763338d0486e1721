// Figures over a box of tolerances: in closed form, against random draws that are measured as they
// are, and at the values that they name.
#include <cmath>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/rasters.h"
#include "verifier/robust/robust_figures.h"

namespace limitgauge::verifier {
namespace {

using model::Interval;
using model::Tolerances;
using model::Vec3;
using namespace tests;

const model::Stock kDeepBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
constexpr double kWidth_mm = 0.0005;

Interval about(double half) {
  return {-half, half};
}

StageCheck check_of(const Tolerances& tolerances) {
  StageCheck check;
  check.resolution_mm = kWidth_mm;
  check.field_spacing_mm = 2;
  check.tolerances = tolerances;
  return check;
}

StageDeviation measured(const ReferenceSurface& surface, const std::vector<Pass>& passes,
                        const StageCheck& check) {
  return measure_stage(surface, kDeepBlock, passes, nullptr, check, {2});
}

Tolerances radius_length_zero(const std::string& tool, double radius, double length, double zero) {
  Tolerances t;
  t.zero_mm = {about(zero), about(zero), about(zero)};
  t.tools[tool] = {about(radius), about(length), {}, {}};
  return t;
}

double value_at(const RobustFigure& figure, const std::string& name) {
  for (const NamedLength& value : figure.at)
    if (value.name == name) return value.mm;
  FAIL("no value of " << name);
  return 0;
}

double ball_scallop(double radius, double step) {
  return radius - std::sqrt(radius * radius - step * step / 4);
}

}  // namespace

TEST_CASE("what a ball leaves of a plane and gouges, over its tolerances, in closed form",
          "[unit]") {
  // The tip goes 10 µm below the plane: nothing but heights deepens that, and between two rows a
  // smaller ball, held higher, leaves most.
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const double radius = 3, step = 0.5, deep = 0.01;
  const std::vector<Pass> passes{
      {ball_cutter(radius), shared(raster(10, step, 5, [&](double, double) { return -deep; }))}};
  const StageDeviation d =
      measured(plane, passes, check_of(radius_length_zero("ball", 0.02, 0.004, 0.003)));
  REQUIRE(d.robust);
  const double heights = 0.007;
  const RobustFigure &gouge = d.robust->gouge, &uncut = d.robust->uncut;
  CHECK(gouge.figure_mm.low <= deep + heights);
  CHECK(gouge.figure_mm.high >= deep + heights);
  CHECK(gouge.figure_mm.width() <= kWidth_mm);
  CHECK(value_at(gouge, "zero.z") == -0.003);
  CHECK(value_at(gouge, "tool.ball.length") == 0.004);
  const double left = ball_scallop(radius - 0.02, step) - deep + heights;
  CAPTURE(left, uncut.figure_mm.low, uncut.figure_mm.high);
  CHECK(uncut.figure_mm.low <= left);
  CHECK(uncut.figure_mm.high >= left);
  CHECK(uncut.figure_mm.width() <= kWidth_mm);
  CHECK(value_at(uncut, "zero.z") == 0.003);
  CHECK(value_at(uncut, "tool.ball.radius") == -0.02);
  CHECK(value_at(uncut, "tool.ball.length") == -0.004);
  for (const NamedLength& s : uncut.sensitivity) {
    CAPTURE(s.name, s.mm);
    if (s.name == "zero.z") CHECK(s.mm == Approx(1).margin(1e-3));
    if (s.name == "tool.ball.length") CHECK(s.mm == Approx(-1).margin(1e-3));
    // Of R − √(R² − s²/4).
    if (s.name == "tool.ball.radius") {
      const double r = radius - 0.02;
      CHECK(s.mm == Approx(1 - r / std::sqrt(r * r - step * step / 4)).margin(1e-3));
    }
  }
}

TEST_CASE("on a slope a shift of the zero counts along the normal, as one of all passes",
          "[unit]") {
  const double slope = 0.75, cosine = 0.8, sine = 0.6, radius = 3, step = 0.25;
  const ReferenceSurface plane(plane_cage(5, slope, 0));
  const std::vector<Pass> passes{
      {ball_cutter(radius), shared(raster(9, step, 9, [&](double x, double) {
         return slope * x + radius / cosine - radius;
       }))}};
  Tolerances t;
  t.zero_mm = {Interval{-0.002, 0.006}, about(0.005), about(0)};
  const StageDeviation d = measured(plane, passes, check_of(t));
  // The rows lie a step apart along the slope too; a shift downhill lifts them off it.
  const double deep = 0.006 * sine, high = 0.002 * sine + ball_scallop(radius, step / cosine);
  CHECK(d.robust->gouge.figure_mm.low == Approx(deep).margin(kWidth_mm));
  CHECK(d.robust->gouge.figure_mm.high == Approx(deep).margin(kWidth_mm));
  CHECK(d.robust->uncut.figure_mm.low == Approx(high).margin(kWidth_mm));
  CHECK(d.robust->uncut.figure_mm.high == Approx(high).margin(kWidth_mm));
  CHECK(value_at(d.robust->gouge, "zero.x") == 0.006);
  CHECK(value_at(d.robust->uncut, "zero.x") == -0.002);
}

TEST_CASE("where errors of single moves are wider than the resolution, few cells are looked at",
          "[unit]") {
  const double slope = 0.2231;
  const ReferenceSurface plane(plane_cage(4, slope, 0));
  model::Cutter bull = flat_cutter(1.553);
  bull.type = model::CutterType::bull, bull.corner_radius_mm = 0.377;
  // Rows a cutter's radius apart, each on its own height: where the wall of one meets the floor of
  // the next a shift of one of them takes the whole step away.
  model::Toolpath path;
  path.start = {-4.67, -6, 50};
  for (const Vec3& tip : {Vec3{-4.67, -6, -0.7807},
                          {-4.67, 6, -0.7807},
                          {-3.13, 6, -0.4338},
                          {-3.13, -6, -0.4366},
                          {-1.588, -6, -0.0926},
                          {-1.588, 6, -0.0926}})
    feed_to(path, tip);
  const std::vector<Pass> passes{{bull, shared(path)}};
  Tolerances t;
  t.zero_mm = {Interval{-0.0016, 0.0001}, about(0.0005), about(0)};
  t.path_mm = 0.0019, t.runout_mm = 0.0016, t.positioning_mm = {0, 0.0026, 0};
  StageCheck check = check_of(t);
  check.resolution_mm = 0.002;
  const RobustFigure uncut = measured(plane, passes, check).robust->uncut;
  // Each move may part from the others by p + q, which the flank makes more of: more than the
  // resolution, and no more than its own steepness makes of it.
  const double width = uncut.figure_mm.high - uncut.figure_mm.low;
  CHECK(width > check.resolution_mm);
  CHECK(width < 8 * (0.0019 + 0.0026));
  // Without an end at those errors it is all that there may be, 240,992, and `high` is 0.6 mm more.
  CHECK(uncut.cells < 100'000);
}

TEST_CASE("without a width a range is a measured value", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const std::vector<Pass> passes{
      {ball_cutter(3), shared(raster(10, 0.5, 5, [&](double, double) { return 0.0; }))}};
  Tolerances t;
  t.zero_mm[2] = {-0.02, -0.02};
  const StageDeviation d = measured(plane, passes, check_of(t));
  CHECK(d.gouge_mm.high <= kWidth_mm);
  CHECK(d.robust->gouge.figure_mm.low == Approx(0.02).margin(kWidth_mm));
  CHECK(d.robust->gouge.figure_mm.high == Approx(0.02).margin(kWidth_mm));
}

TEST_CASE("figures over tolerances and margins are the same for any number of threads",
          "[unit][slow]") {
  const ReferenceSurface bowl(paraboloid_cage(3, 0.08));
  const std::vector<Pass> passes{
      {ball_cutter(2), shared(raster(3, 0.5, 0.5, [](double x, double y) {
         return 0.08 * (x * x + y * y) + 0.02;
       }))}};
  StageCheck check = check_of(radius_length_zero("ball", 0.01, 0.005, 0.005));
  check.limits.has_gouge = check.limits.has_uncut = true;
  check.limits.gouge_mm = check.limits.uncut_mm = 0.03;
  const auto by = [&](unsigned threads) {
    return *measure_stage(bowl, kDeepBlock, passes, nullptr, check, {threads}).robust;
  };
  const RobustDeviation one = by(1), four = by(4);
  for (const auto figure : {&RobustDeviation::gouge, &RobustDeviation::uncut}) {
    const RobustFigure &a = one.*figure, &b = four.*figure;
    CHECK(a.figure_mm.low == b.figure_mm.low);
    CHECK(a.figure_mm.high == b.figure_mm.high);
    REQUIRE((a.margin && b.margin));
    CHECK(a.margin->proven == b.margin->proven);
    CHECK(a.margin->refuted == b.margin->refuted);
    REQUIRE(a.at.size() == b.at.size());
    for (std::size_t k = 0; k < a.at.size(); ++k) {
      CHECK(a.at[k].mm == b.at[k].mm);
      CHECK(a.sensitivity[k].mm == b.sensitivity[k].mm);
    }
  }
}

namespace {

/// A part and the passes over it that the draws are taken of.
struct Sloppy {
  std::string name;
  model::Cage cage;
  std::vector<Pass> passes;
  Tolerances tolerances;
};

std::vector<Sloppy> sloppy_parts() {
  std::vector<Sloppy> out;
  const auto bowl = [](double x, double y) { return 0.08 * (x * x + y * y); };
  const auto over_bowl = [&](double lift) {
    return shared(raster(3, 0.5, 0.5, [=](double x, double y) {
      return bowl(x, y) + lift + 0.04 * std::sin(2 * x + y);
    }));
  };
  model::Cutter bull{"bull", model::CutterType::bull, 3, 0.6, 0, 40, {}, {}};
  model::Cutter taper{"taper", model::CutterType::taper, 2, 0.4, 5, 20, {}, {}};
  const auto add = [&](const char* name, std::vector<Pass> passes, const Tolerances& t) {
    out.push_back({name, paraboloid_cage(3, 0.08), std::move(passes), t});
  };
  Tolerances common = radius_length_zero("ball", 0.01, 0.005, 0.005);
  add("ball", {{ball_cutter(2), over_bowl(0.02)}}, common);
  add("flat, worn corner", {{flat_cutter(1), over_bowl(0.15)}}, [] {
    Tolerances t = radius_length_zero("flat", 0.01, 0.004, 0.006);
    t.tools["flat"].corner_radius_mm = {0, 0.05};
    return t;
  }());
  add("bull", {{bull, over_bowl(0.1)}}, [] {
    Tolerances t = radius_length_zero("bull", 0, 0.004, 0.008);
    t.tools["bull"].radius_mm = {};
    t.tools["bull"].corner_radius_mm = {-0.03, 0.02};
    t.tools["bull"].flat_mm = {-0.02, 0.01};
    return t;
  }());
  add("taper", {{taper, over_bowl(0.1)}}, radius_length_zero("taper", 0.01, 0.006, 0.004));
  add("two tools", {{bull, over_bowl(0.25)}, {ball_cutter(2), over_bowl(0.01)}}, [] {
    Tolerances t = radius_length_zero("ball", 0.01, 0.005, 0.005);
    t.tools["bull"] = {about(0.02), about(0.01), {}, {}};
    return t;
  }());
  add("each move", {{ball_cutter(2), over_bowl(0.02)}}, [] {
    Tolerances t = radius_length_zero("ball", 0.004, 0.003, 0.002);
    t.path_mm = 0.002, t.runout_mm = 0.003, t.positioning_mm = {0.002, 0.001, 0.001};
    return t;
  }());
  return out;
}

ToleranceValues drawn(const ToleranceBox& box, double path_mm, std::mt19937& random) {
  ToleranceValues values;
  for (const Tolerance& t : box.tolerances())
    values.push_back(std::uniform_real_distribution(t.range_mm.low, t.range_mm.high)(random));
  Vec3 off{std::normal_distribution()(random), std::normal_distribution()(random),
           std::normal_distribution()(random)};
  return box.off_path(std::move(values), normalized(off) * path_mm);
}

/// The values that the figures name reach them within a nanometre.
void check_named(const Sloppy& part, const ReferenceSurface& surface, const StageDeviation& d,
                 const StageCheck& as_stated) {
  const ToleranceBox box(part.tolerances, part.passes);
  const SurfaceCells cells(surface.tree(), 1);
  for (const Side side : {Side::gouge, Side::uncut}) {
    const RobustFigure& figure = side == Side::uncut ? d.robust->uncut : d.robust->gouge;
    REQUIRE(figure.place);
    REQUIRE(figure.at.size() == box.tolerances().size());
    ToleranceValues values;
    for (const NamedLength& value : figure.at) values.push_back(value.mm);
    const std::vector<Pass> passes = box.passes_at(values);
    const RemovedSpace space(kDeepBlock, passes);
    RunBounds bounds(cells, space, side, 0);
    const double run = bounds.run(figure.place->point, figure.normal).length_mm;
    CHECK(run >= figure.figure_mm.low - 1e-6);
    const StageDeviation one = measured(surface, passes, as_stated);
    const Interval& there = side == Side::uncut ? one.uncut_mm : one.gouge_mm;
    CHECK(there.high >= figure.figure_mm.low);
    CHECK(there.low <= figure.figure_mm.high);
  }
}

}  // namespace

TEST_CASE("what is drawn from the tolerances stays within what is certified, named values reach it",
          "[property][slow]") {
  std::mt19937 random(22);
  for (const Sloppy& part : sloppy_parts()) {
    const ReferenceSurface surface(part.cage);
    StageCheck check = check_of(part.tolerances);
    const StageDeviation d = measured(surface, part.passes, check);
    CAPTURE(part.name);
    const Interval gouge = d.robust->gouge.figure_mm, uncut = d.robust->uncut.figure_mm;
    CAPTURE(gouge.low, gouge.high, uncut.low, uncut.high, d.gouge_mm.high, d.uncut_mm.high);
    CHECK(gouge.width() <= kWidth_mm);
    // What each move is off by for itself no one draw shows whole.
    CHECK(uncut.width() <=
          kWidth_mm + 2 * ToleranceBox(part.tolerances, part.passes).gap_mm(Side::uncut));
    check.tolerances.reset();
    const ToleranceBox box(part.tolerances, part.passes);
    for (int k = 0; k < by_effort(1, 40); ++k) {
      const std::vector<Pass> passes = box.passes_at(drawn(box, part.tolerances.path_mm, random));
      const StageDeviation one = measured(surface, passes, check);
      CHECK(one.gouge_mm.low <= gouge.high);
      CHECK(one.uncut_mm.low <= uncut.high);
    }
    check_named(part, surface, d, check);
  }
}

}  // namespace limitgauge::verifier
