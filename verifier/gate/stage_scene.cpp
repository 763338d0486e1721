#include "verifier/gate/stage_scene.h"

#include <algorithm>
#include <numbers>

#include "verifier/surface/surface_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// For how long the rim of what can be reached is resolved. The contact of a flat moves far as the
/// normal turns, so its proofs take smaller cells. To a cutter as wide as the part every cell is
/// near every other, and of a drill's or an undercutting cutter's contacts no cell is proven: then
/// each is looked at once.
ReachOptions reach_effort(const CutterProfile& cutter, double area_mm2) {
  ReachOptions effort = kReachEffort;
  const double radius = cutter.rounding_mm + cutter.flat_mm;
  if (cutter.is_pointed() || cutter.undercuts() ||
      std::numbers::pi * radius * radius > area_mm2 / 2)
    effort.largest_cell_count = 1;
  else if (cutter.flat_mm > 0)
    effort.largest_cell_count = 250'000;
  return effort;
}

CertificateRequest request_of(const StageCheck& check) {
  const double unlimited = std::numeric_limits<double>::infinity();
  return {check.allowance_mm, check.limits.has_gouge ? check.limits.gouge_mm : unlimited,
          check.limits.has_uncut ? check.limits.uncut_mm : unlimited, check.resolution_mm,
          check.largest_cell_count};
}

/// The cutters used so far, each of its kind once: that of the last pass first.
std::vector<model::Cutter> distinct_cutters(std::span<const Pass> passes) {
  std::vector<model::Cutter> out;
  for (std::size_t k = passes.size(); k-- > 0;) {
    model::Cutter cutter = passes[k].cutter;
    cutter.id.clear();
    const std::string text = to_text(cutter);
    const bool known = std::any_of(
        out.begin(), out.end(), [&](const model::Cutter& other) { return to_text(other) == text; });
    if (!known) out.push_back(std::move(cutter));
  }
  return out;
}

std::vector<Sweep> sweeps_of(std::span<const AssemblySweep> parts) {
  std::vector<Sweep> sweeps;
  for (const AssemblySweep& part : parts) sweeps.push_back(part.sweep);
  return sweeps;
}

}  // namespace

ReachOfCutters::ReachOfCutters(const SurfaceCells& cells, std::span<const Pass> passes,
                               double allowance_mm, double area_mm2)
    : cutters(distinct_cutters(passes)) {
  for (const model::Cutter& cutter : cutters) {
    const CutterProfile profile(cutter);
    searches.emplace_back(cells, cutter, allowance_mm, kContact_mm);
    efforts.push_back(reach_effort(profile, area_mm2));
  }
}

StageScene::StageScene(const ReferenceSurface& surface, const model::Stock& raw_stock,
                       std::span<const Pass> passes, const StageCheck& check)
    : highest_mm(surface.bounding_box().high.z + check.allowance_mm + kRounding_mm),
      cells(surface.tree(), first_cell_radius_mm(surface.tree())),
      cut(raw_stock, passes),
      raw(raw_stock, {}),
      parts(assembly_sweeps(passes, highest_mm)),
      by(cells, passes, check.allowance_mm, surface.area_mm2()),
      request(request_of(check)) {
  if (!parts.empty()) with_parts_.emplace(cut.with(sweeps_of(parts)));
}

}  // namespace limitgauge::verifier
