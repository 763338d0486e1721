// The parts of an assembly are one body, whatever slices they come in.
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

enum class Made { one_cylinder, slices, holder_parts };

/// Flutes of radius 1.7 mm and 3 mm long; above them 2 mm of radius `shank_mm`.
model::Cutter assembly(double shank_mm, Made made) {
  model::Cutter cutter = flat_cutter(1.7);
  cutter.flute_length_mm = 3;
  constexpr int kSlices = 40;
  for (int k = 0; k < (made == Made::one_cylinder ? 1 : kSlices); ++k) {
    const model::CylinderPart part{2 * shank_mm, made == Made::one_cylinder ? 2.0 : 2.0 / kSlices};
    (made == Made::holder_parts ? cutter.holder : cutter.shank).push_back(part);
  }
  return cutter;
}

}  // namespace

TEST_CASE("a shank runs as deep into a wall in slices as in one piece", "[unit][definition2]") {
  // A wall 10 mm tall at x = 0, the part at x > 0; the flutes touch it and the shank is 0.2 mm
  // wider.
  const ReferenceSurface wall(drawn_outline({{-5, 0}, {0, 0}, {0, 10}, {5, 10}}, 8));
  const auto block = block_between({-6, -5, -4}, {6, 5, 10});
  const model::Toolpath path = moves_through({{-1.7, -9, 0}, {-1.7, 9, 0}});
  for (const Made made : {Made::one_cylinder, Made::slices, Made::holder_parts}) {
    const std::vector<Pass> passes = {pass_of(assembly(1.9, made), path)};
    const Judged judged = judge(wall, block, passes, gouge_gate(0.05));
    CAPTURE(static_cast<int>(made), judged.deviation.gouge_mm.low, judged.deviation.gouge_mm.high);
    CHECK(judged.decision.verdict == Verdict::fail);
    const StageDeviation d = measured(wall, block, passes, 0.002);
    CAPTURE(d.gouge_mm.low, d.gouge_mm.high);
    CHECK(d.gouge_mm.low <= 0.2 + 1e-9);
    CHECK(d.gouge_mm.high >= 0.2 - 1e-9);
    CHECK(d.gouge_mm.width() <= 0.002);
    // One that keeps off the wall passes, in slices too.
    const std::vector<Pass> clear = {pass_of(assembly(1.6, made), path)};
    CHECK(judge(wall, block, clear, gouge_gate(0.05)).decision.verdict == Verdict::pass);
  }
}

}  // namespace limitgauge::verifier
