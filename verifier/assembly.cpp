#include "verifier/assembly.h"

#include <algorithm>

namespace limitgauge::verifier {
namespace {

double lowest_tip_mm(const model::Toolpath& path) {
  double lowest = path.start.z;
  for (const model::Move& move : path.moves) lowest = std::min(lowest, move.to.z);
  return lowest;
}

void stack(const std::vector<model::CylinderPart>& parts, const char* name, double& base_mm,
           std::vector<AssemblyBody>& out) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string numbered = name;
    if (parts.size() > 1) numbered += " " + std::to_string(i + 1);
    out.push_back({std::move(numbered), CutterProfile(parts[i]), base_mm});
    base_mm += parts[i].length_mm;
  }
}

}  // namespace

std::vector<AssemblyBody> bodies_above_flutes(const model::Cutter& cutter) {
  std::vector<AssemblyBody> bodies;
  double base_mm = cutter.flute_length_mm;
  stack(cutter.shank, "shank", base_mm, bodies);
  stack(cutter.holder, "holder", base_mm, bodies);
  return bodies;
}

std::vector<BodySweep> certify_assemblies(const SurfaceCells& cells, std::span<const Pass> passes,
                                          const CertificateRequest& request,
                                          const model::RunControl& control) {
  std::vector<BodySweep> out;
  // No point of the allowance surface is higher than this.
  const double highest_mm =
      cells.nodes().empty() ? 0 : cells.nodes().front().box.high.z + request.allowance_mm;
  for (std::size_t stage = 0; stage < passes.size(); ++stage) {
    const Pass& pass = passes[stage];
    const double lowest_mm = lowest_tip_mm(*pass.path) - pass.path->chord_error_mm;
    for (const AssemblyBody& body : bodies_above_flutes(pass.cutter)) {
      BodySweep& sweep = out.emplace_back(BodySweep{stage, body.name, {}, {}});
      if (lowest_mm + body.lift_mm > highest_mm + kRounding_mm) continue;
      const Sweep swept{body.profile, body.lift_mm, pass.path};
      sweep.space.emplace(std::span(&swept, 1));
      sweep.certificate = certify(cells, *sweep.space, nullptr, request, control);
    }
  }
  return out;
}

}  // namespace limitgauge::verifier
