#include "verifier/cutter/assembly.h"

#include <algorithm>

namespace limitgauge::verifier {
namespace {

double lowest_tip_mm(const model::Toolpath& path) {
  double lowest = path.start.z;
  for (const model::Move& move : path.moves) lowest = std::min(lowest, move.to.z);
  return lowest - path.chord_error_mm;
}

struct StackedPart {
  std::string body;
  model::CylinderPart part;
  double lift_mm = 0;
};

void stack(const std::vector<model::CylinderPart>& parts, const char* body, double& base_mm,
           std::vector<StackedPart>& out) {
  for (const model::CylinderPart& part : parts) {
    const bool goes_on =
        !out.empty() && out.back().body == body && out.back().part.diameter_mm == part.diameter_mm;
    if (goes_on)
      out.back().part.length_mm += part.length_mm;
    else
      out.push_back({body, part, base_mm});
    base_mm += part.length_mm;
  }
}

std::vector<StackedPart> parts_above_flutes(const model::Cutter& cutter) {
  std::vector<StackedPart> parts;
  double base_mm = cutter.flute_length_mm;
  stack(cutter.shank, "shank", base_mm, parts);
  stack(cutter.holder, "holder", base_mm, parts);
  return parts;
}

}  // namespace

std::vector<AssemblySweep> assembly_sweeps(std::span<const Pass> passes,
                                           const model::Box3& region) {
  std::vector<AssemblySweep> out;
  for (std::size_t stage = 0; stage < passes.size(); ++stage) {
    const Pass& pass = passes[stage];
    const double lowest_mm = lowest_tip_mm(*pass.path);
    const double highest_mm =
        pass.pose == model::Pose{} ? region.high.z : pass.pose.inverse().box(region).high.z;
    for (const StackedPart& part : parts_above_flutes(pass.cutter))
      if (pass.axes || lowest_mm + part.lift_mm <= highest_mm)
        out.push_back({stage,
                       part.body,
                       {CutterProfile(part.part), part.lift_mm, pass.path, pass.pose, pass.axes}});
  }
  return out;
}

std::vector<AssemblySweep> assembly_sweeps(std::span<const Pass> passes, double highest_mm) {
  model::Box3 region;
  region.high.z = highest_mm;
  return assembly_sweeps(passes, region);
}

}  // namespace limitgauge::verifier
