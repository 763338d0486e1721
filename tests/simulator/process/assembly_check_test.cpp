// The parts of an assembly are one body, whatever pieces it is stated in, and what counts as a
// contact does not depend on the voxel.
#include <cmath>

#include "simulator/process/tool_bodies.h"
#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"
#include "tests/support/solid_meshes.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using model::CutterType;
using model::CylinderPart;
using simulator::Finding;
using simulator::FindingKind;
using simulator::StockModel;

// Depths are lower bounds, as a rule within a tolerance of the deepest.
constexpr double kDepth = 0.2;

/// Flutes of D3.4, and 2 mm of D3.8 above them.
model::Cutter with_shank(std::vector<CylinderPart> shank, std::vector<CylinderPart> holder = {}) {
  model::Cutter c = cutter(CutterType::flat, 3.4, 5);
  c.shank = std::move(shank);
  c.holder = std::move(holder);
  return c;
}

std::vector<CylinderPart> slices(int count, double diameter, double other) {
  std::vector<CylinderPart> out;
  for (int k = 0; k < count; ++k) out.push_back({k % 2 ? other : diameter, 2.0 / count});
  return out;
}

std::vector<model::Cutter> statements_of_one_shank() {
  const auto half = [](double d) { return std::vector<CylinderPart>{{d, 1}}; };
  return {with_shank({{3.8, 2}}), with_shank(slices(40, 3.8, 3.8)), with_shank({}, {{3.8, 2}}),
          with_shank({}, slices(40, 3.8, 3.8)), with_shank(half(3.8), half(3.8))};
}

/// A slot as wide as the flutes and deep enough for all of it.
StockModel slotted(double voxel_mm = 0.25) {
  const StockModel block{model::BoxStock{{-15, -10, -8}, {30, 20, 8}}, voxel_mm,
                         std::size_t{1} << 30};
  return block.cut(
      PathBuilder({-20, 0, -6}).feed({20, 0, -6}).pass(cutter(CutterType::flat, 3.4, 20)), {2});
}

/// In the slot's whole length, with the shank's lower half in it; or above all stock.
simulator::Pass along(const model::Cutter& c, double z = -6) {
  return PathBuilder({-20, 0, z}).feed({20, 0, z}).pass(c);
}

double deepest(const std::vector<Finding>& all, FindingKind kind) {
  double depth = 0;
  for (const Finding& f : of_kind(all, kind)) depth = std::max(depth, f.depth_mm);
  return depth;
}

}  // namespace

TEST_CASE("a shank in a wall is as deep in slices, and as holder parts, as in one piece",
          "[unit][assembly]") {
  for (const model::Cutter& c : statements_of_one_shank()) {
    CAPTURE(c.shank.size(), c.holder.size());
    const auto found = check(slotted(), along(c));
    REQUIRE(!found.empty());
    for (const Finding& f : found) {
      CHECK((f.kind == FindingKind::shank_in_stock || f.kind == FindingKind::holder_in_stock));
      CHECK(f.depth_mm <= kDepth + 1e-9);
      CHECK(f.depth_mm >= kDepth - kTolerance);
    }
  }
}

TEST_CASE("a shank that rises into a wall before its flutes is found in one move as in many",
          "[unit][assembly]") {
  // D4 with flutes of 2 mm, from beside the block up and into its wall: its own flutes get there
  // later. When u of the move is gone the shank's lower edge is 5u − 0.2 behind the wall and 5 − 7u
  // below the block's top: as deep in the one as in the other at u = 5.2/12. That is the depth in
  // the material as it was before; as it is by then the flutes have been below, and nothing is
  // deeper than half of 5 − 7u, which at u = 2.7/8.5 is as deep as it is behind the wall.
  constexpr double kBefore = 5 * 5.2 / 12 - 0.2, kThen = 5 * 2.7 / 8.5 - 0.2;
  model::Cutter c = flat4(2);
  for (const bool has_shank : {true, false}) {
    c.shank.clear();
    if (has_shank) c.shank = {{4, 40}};
    const auto kind = has_shank ? FindingKind::shank_in_stock : FindingKind::below_flutes;
    const auto one = PathBuilder({-17.2, 0, -7}).feed({-12.2, 0, 0}).pass(c);
    for (const int pieces : {1, 2, 7, 100}) {
      CAPTURE(has_shank, pieces);
      const double depth = deepest(check(block(), split(one, pieces)), kind);
      CHECK(depth <= kBefore + 1e-9);
      CHECK(depth >= (pieces == 1 ? kBefore : kThen) - 2 * kTolerance);
    }
    // A tool that could turn goes the same way.
    simulator::Pass held = one;
    auto axes = std::make_shared<model::ToolAxes>();
    axes->to = {{0, 0, 1}};
    held.axes = axes;
    const double depth = deepest(check(block(), held), kind);
    CHECK(depth <= kBefore + 1e-9);
    CHECK(depth >= kBefore - 2 * kTolerance);
  }
}

TEST_CASE("the voxel decides nothing about contacts", "[unit][assembly]") {
  for (const double voxel : {0.08, 0.15, 0.25, 0.5}) {
    CAPTURE(voxel);
    const auto found = check(slotted(voxel), along(with_shank(slices(40, 3.8, 3.8))));
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == FindingKind::shank_in_stock);
    CHECK(found[0].depth_mm == Approx(kDepth).margin(kTolerance));
    CHECK(check(slotted(voxel), along(with_shank(slices(40, 3.4, 3.4)))).empty());
  }
}

TEST_CASE("a contact within the tolerance is listed and fails nothing", "[unit][assembly]") {
  // The shank is 6 µm wider than the slot on either side.
  for (const double voxel : {0.1, 0.5}) {
    const auto found = check(slotted(voxel), along(with_shank({{3.412, 2}})));
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == FindingKind::slight_contact);
    CHECK_FALSE(fails(found[0].kind));
    CHECK(found[0].part == "shank");
    CHECK(found[0].depth_mm <= 0.006 + 1e-9);
    CHECK(found[0].depth_mm >= 0.006 - kTolerance / 5);
  }
  // Deeper than half as much again as the tolerance, it is never one of those.
  const auto deep = check(slotted(), along(with_shank({{3.432, 2}})));
  REQUIRE(deep.size() == 1);
  CHECK(deep[0].kind == FindingKind::shank_in_stock);
  // A clamp's edge 5 µm in the flutes.
  simulator::ProcessLimits limits = plain_limits();
  limits.fixtures = {fixture("clamp", box_mesh({{-5, 1.695, 1}, {5, 6, 9}}))};
  const auto clamp = check(block(), along(with_shank({}), 2), limits);
  REQUIRE(clamp.size() == 1);
  CHECK(clamp[0].kind == FindingKind::slight_contact);
  CHECK(clamp[0].against == "clamp");
  CHECK(clamp[0].depth_mm == Approx(0.005).margin(kTolerance / 5));
}

TEST_CASE("a clamp in a shank is as deep in slices as in one piece", "[unit][assembly]") {
  // The clamp's face stands 0.2 mm inside the shank, beside all of it and above.
  simulator::ProcessLimits limits = plain_limits();
  limits.fixtures = {fixture("clamp", box_mesh({{-5, 1.7, 3}, {5, 6, 30}}))};
  std::vector<model::Cutter> all = statements_of_one_shank();
  // Slices of two diameters are no cylinder, but one goes through all of them.
  all.push_back(with_shank(slices(40, 3.8, 3.81)));
  all.push_back(with_shank(slices(20, 3.8, 3.81), slices(20, 3.81, 3.8)));
  for (const model::Cutter& c : all) {
    CAPTURE(c.shank.size(), c.holder.size());
    const auto found = check(block(), along(c, 2), limits);
    const double depth = deepest(found, FindingKind::fixture_touched);
    CHECK(depth >= kDepth - 0.001);
    CHECK(depth <= kDepth + 0.005 + 1e-6);
  }
}

TEST_CASE("a thin plate between flutes and shank is as deep as it goes into both",
          "[unit][assembly]") {
  // 20 µm thick, and 1 mm in the cutter where the flutes end.
  simulator::ProcessLimits limits = plain_limits();
  limits.fixtures = {fixture("plate", box_mesh({{-5, 0.7, 6.99}, {5, 6, 7.01}}))};
  for (const auto& shank : {std::vector<CylinderPart>{{3.4, 4}},
                            std::vector<CylinderPart>{{3.8, 4}}, slices(8, 3.4, 3.4)}) {
    const auto found = check(block(), along(with_shank(shank), 2), limits);
    const double depth = deepest(found, FindingKind::fixture_touched);
    CHECK(depth >= 1 - 0.001 - 1e-6);
    CHECK(depth <= 1 + 0.2 + 1e-6);
  }
}

TEST_CASE("cylinders through several parts lie in the assembly", "[unit][assembly]") {
  model::Cutter c = cutter(CutterType::ball, 4, 6);
  c.shank = {{3, 5}, {3, 2}, {5, 1}, {4, 3}};
  c.holder = {{20, 10}, {30, 5}};
  const simulator::ToolBodies bodies(c, 100);
  CHECK(bodies.above.size() == 5);
  const auto radius_at = [&](double z) {
    if (z < 2) return std::sqrt(std::max(0.0, 4 - (2 - z) * (2 - z)));
    if (z < 6) return 2.0;
    double base = 6;
    for (const auto& parts : {c.shank, c.holder})
      for (const CylinderPart& p : parts)
        if (z < (base += p.length_mm)) return p.diameter_mm / 2;
    return 0.0;
  };
  REQUIRE(!bodies.joined.empty());
  for (const simulator::ToolBody& body : bodies.joined)
    for (double z = body.base_mm + 1e-9; z < body.base_mm + body.profile.length() - 1e-9; z += 0.01)
      CHECK(body.profile.sample(radius_at(z) + 1e-9, z - body.base_mm).distance >= -1e-9);
  CHECK(bodies.part_at(3) == simulator::ToolPart::cutter);
  CHECK(bodies.part_at(6.5) == simulator::ToolPart::shank);
  CHECK(bodies.part_at(18) == simulator::ToolPart::holder);
}

TEST_CASE("what slides along a raw stock that is a mesh is cleared quickly", "[unit][assembly]") {
  const StockModel mesh{tests::mesh_stock(tests::box_mesh({-15, -10, -8}, {30, 20, 8})), 0.25,
                        std::size_t{1} << 30};
  // On the top, along a side, and 1 µm over a tenth of the tolerance into the top.
  const model::Cutter c = flat4();
  CHECK(check(mesh, PathBuilder({-20, 0, 0}).rapid({20, 3, 0}).pass(c)).empty());
  CHECK(check(mesh, PathBuilder({-20, 12, -4}).rapid({20, 12, -4}).pass(c)).empty());
  const auto slight = check(mesh, PathBuilder({-20, 0, -0.002}).rapid({20, 3, -0.002}).pass(c));
  REQUIRE(slight.size() == 1);
  CHECK(slight[0].kind == FindingKind::slight_contact);
  const auto deep = check(mesh, PathBuilder({-20, 0, -0.2}).rapid({20, 3, -0.2}).pass(c));
  REQUIRE(deep.size() == 1);
  CHECK(deep[0].depth_mm == Approx(0.2).margin(kTolerance));
}
