#include "tests/defects/orientations/lying_suite.h"

#include <cmath>

#include "tests/defects/surfaces/surfaces.h"
#include "tests/support/cages.h"
#include "tests/support/folders.h"

namespace limitgauge::tests::defects {
namespace {

/// Parts and cutters of half the suite's size: 5 to 7 mm, so that a job takes a second or two.
constexpr double kScale = 0.5;

model::Cutter small(model::Cutter cutter) {
  cutter.diameter_mm *= kScale, cutter.corner_radius_mm *= kScale;
  cutter.flute_length_mm *= kScale;
  return cutter;
}

/// A part that is cut from a little beside its own axis. A closed one has six times the surface.
model::Cage leaning(const NamedCage& part, std::mt19937& random) {
  constexpr double kMost_deg = 12;
  const double a = between(random, 0, 6.28318);
  const double scale = part.name == "rounded cube" ? kScale / 2 : kScale;
  return model::turned(placed(part.cage, {scale, 0, {}}),
                       turned_about({std::cos(a), std::sin(a), 0}, between(random, 0, kMost_deg)));
}

std::vector<LyingKind> kinds_for(Holding holding, std::size_t turn, std::size_t count) {
  // The lost word is of machines alone.
  const std::size_t kinds = std::size(kLyingKinds) - (holding == Holding::still ? 1 : 0);
  std::vector<LyingKind> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(kLyingKinds[(turn + k) % kinds]);
  return out;
}

}  // namespace

std::vector<LyingPlan> lying_plans(unsigned seed, std::size_t defects, std::size_t twins) {
  const std::vector<NamedCage> surfaces = suite_surfaces(tests::fixtures().string());
  const std::vector<model::Cutter> cutters = suite_cutters();
  constexpr Holding kOnMachines[] = {Holding::table_table, Holding::head_table, Holding::head_head};
  std::vector<LyingPlan> plans;
  for (std::size_t k = 0, planted = 0; k < twins; ++k) {
    LyingPlan plan;
    plan.seed = seed * 1000 + static_cast<unsigned>(k);
    std::mt19937 random(plan.seed + 500'000'000);
    const NamedCage& surface = surfaces[(k / 2 * 5 + k % 2 * 3) % surfaces.size()];
    plan.surface_name = surface.name, plan.cage = leaning(surface, random);
    plan.cutter = small(cutters[(k / 2 + k / 8) % cutters.size()]);
    plan.step_mm = 0.2 + 0.05 * static_cast<double>(k % 4);
    plan.across = static_cast<int>(k / 2 % 2);
    plan.allowance_mm = k % 5 == 4 ? 0.05 : 0;
    plan.holding = k % 2 == 0 ? Holding::still : kOnMachines[k / 2 % 3];
    const std::size_t count = defects * (k + 1) / twins - planted;
    plan.kinds = kinds_for(plan.holding, planted / 2 + k % 3, count);
    planted += count;
    plans.push_back(std::move(plan));
  }
  return plans;
}

}  // namespace limitgauge::tests::defects
