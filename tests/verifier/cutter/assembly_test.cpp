#include "verifier/cutter/assembly.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

const model::Stock kBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};

/// A ball of radius 1 on short flutes, under a shank of `shank_radius` and a wide holder.
model::Cutter assembly(double flutes_mm, double shank_radius) {
  return {"short",   model::CutterType::ball,  2,        1, 0,
          flutes_mm, {{2 * shank_radius, 10}}, {{30, 5}}};
}

model::Toolpath single_move(const Vec3& from, const Vec3& to) {
  model::Toolpath path;
  path.start = from;
  feed_to(path, to);
  return path;
}

StageDeviation measure(const ReferenceSurface& surface, const model::Cutter& cutter,
                       model::Toolpath path, const GateLimits& limits = {}) {
  const Pass pass{cutter, shared(std::move(path))};
  StageCheck check;
  check.resolution_mm = 0.001;
  check.field_spacing_mm = 1;
  check.limits = limits;
  return measure_stage(surface, kBlock, {&pass, 1}, nullptr, check, {2});
}

const BodyFigure& figure_of(const StageDeviation& d, const std::string& body) {
  for (const BodyFigure& b : d.bodies)
    if (b.body == body) return b;
  FAIL("no figure of " << body);
  return d.bodies.front();
}

}  // namespace

TEST_CASE("parts are named and stacked from the tip up, equal ones as one", "[unit]") {
  const model::Cutter cutter{"c",       model::CutterType::flat,      4, 0, 0, 12,
                             {{4, 20}}, {{20, 5}, {40, 10}, {40, 20}}};
  const Pass pass{cutter, shared(single_move({0, 0, 0}, {1, 0, 0}))};
  const auto parts = assembly_sweeps({&pass, 1}, 100);
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].body == "shank");
  CHECK(parts[0].sweep.lift_mm == 12);
  CHECK(parts[1].body == "holder");
  CHECK(parts[1].sweep.lift_mm == 32);
  CHECK(parts[2].sweep.lift_mm == 37);
  CHECK(parts[2].sweep.profile.flat_mm == 20);
  CHECK(parts[2].sweep.profile.top_mm == 30);
  // Those that stay above everything are left out.
  CHECK(assembly_sweeps({&pass, 1}, 36).size() == 2);
}

TEST_CASE("a shank that rubs along a slope gouges by the closed form", "[unit]") {
  // The plane z = x; the tip runs along y at x = 0, a ball of radius 1 that touches it. The lower
  // edge of the shank, `flutes` over the tip, is `reach` towards the plane.
  const double tip_z = std::sqrt(2.0) - 1, flutes = 3;
  const ReferenceSurface plane(plane_cage(8, 1, 0));
  const auto path = single_move({0, -2, tip_z}, {0, 2, tip_z});
  for (const double reach : {3.2, 3.45, 3.6}) {
    // The plane is inside the shank from its lower face to its wall; the middle is deepest, and the
    // way out along the normal goes to the edge between them.
    const double face = tip_z + flutes, depth = std::max(0.0, (reach - face) / std::sqrt(2.0));
    const StageDeviation d = measure(plane, assembly(flutes, reach), path);
    const Interval shank = figure_of(d, "shank").gouge_mm;
    CAPTURE(reach, depth, shank.low, shank.high);
    CHECK(shank.low <= depth);
    CHECK(shank.high >= depth);
    CHECK(shank.width() <= 0.001);
    CHECK(figure_of(d, "cutter").gouge_mm.high <= 0.001);
    CHECK(d.gouge_mm.low == shank.low);
    if (depth == 0) continue;
    REQUIRE(!d.gouges.empty());
    CHECK(d.gouges.front().body == "shank");
    CHECK(d.gouges.front().line == 1);
    CHECK(std::abs(d.gouges.front().place.point.x - (reach + face) / 2) < 0.01);
    const GateLimits limits{true, false, false, 0.01, 0, 0};
    const GateDecision decision =
        decide(measure(plane, assembly(flutes, reach), path, limits), limits);
    CHECK(decision.verdict == Verdict::fail);
    CHECK(decision.reasons.front().find("by the shank") != std::string::npos);
  }
}

TEST_CASE("what stays above the part is clear of it, exactly", "[unit]") {
  const ReferenceSurface dome(paraboloid_cage(6, -0.05));
  const auto d = measure(dome, assembly(8, 1), single_move({-4, 0, 0}, {4, 0, 0}));
  REQUIRE(d.bodies.size() == 1);
  CHECK(d.bodies.front().body == "cutter");
}

TEST_CASE("a holder over a hill that the flutes avoid", "[slow]") {
  // The tip is 10 mm out and the holder, of radius 15, reaches over the top of the hill.
  const ReferenceSurface hill(paraboloid_cage(12, -0.0125));
  model::Cutter cutter{"stub", model::CutterType::ball, 2, 1, 0, 1.5, {}, {{30, 5}}};
  const double foot = -0.0125 * 100;
  const auto d = measure(hill, cutter, single_move({10, 0, foot}, {10, 1, foot}));
  // Its lower face is at foot + flute length, 0.25 mm over the top of the hill at 0: it comes
  // nowhere as low as the surface, so that there is no figure of it.
  REQUIRE(d.bodies.size() == 1);
  CHECK(d.bodies.front().body == "cutter");
  cutter.flute_length_mm = 1.0;
  const auto deep = measure(hill, cutter, single_move({10, 0, foot}, {10, 1, foot}));
  // Now the face is 0.25 mm under the top, where the normal is vertical; down the slope the run
  // along the normal is longer than the height by less than the slope takes off it.
  const Interval pressed = figure_of(deep, "holder").gouge_mm;
  CHECK(pressed.low <= 0.25);
  CHECK(pressed.high >= 0.25);
  CHECK(pressed.width() <= 0.001);
}

}  // namespace limitgauge::verifier
