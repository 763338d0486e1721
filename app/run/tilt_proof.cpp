#include "app/run/tilt_proof.h"

#include <limits>

#include "app/run/cut_stock.h"
#include "model/text/number_text.h"
#include "reports/run/process.h"
#include "verifier/certificate/certificate.h"
#include "verifier/cutter/assembly.h"

namespace limitgauge::app {
namespace {

const verifier::ReferenceSurface& surface_of(const RunInputs& inputs) {
  return inputs.design.value().surface;
}

verifier::SurfaceCells cells_of(const RunInputs& inputs) {
  const auto& tree = surface_of(inputs).tree();
  return {tree, verifier::first_cell_radius_mm(tree)};
}

std::vector<verifier::Sweep> assembly_of(const model::Pass& pass, const model::Box3& region) {
  std::vector<verifier::Sweep> sweeps;
  for (const verifier::AssemblySweep& part : verifier::assembly_sweeps({&pass, 1}, region))
    sweeps.push_back(part.sweep);
  return sweeps;
}

}  // namespace

TiltProof::TiltProof(const Job& at_setup, const RunInputs& inputs, std::size_t stage,
                     const simulator::StockModel& stock, const StageWatch& watch)
    : job_(at_setup),
      inputs_(inputs),
      stage_(at_setup.stages[stage]),
      stock_(stock),
      watch_(watch),
      resolution_mm_(inputs.settings.resolution_mm[stage]),
      gouge_mm_(stage_.limits.has_gouge ? stage_.limits.gouge_mm : stage_.plan->cut.tolerance_mm),
      cells_(cells_of(inputs)) {}

std::optional<std::string> TiltProof::against_part(const model::Pass& pass) const {
  const double unlimited = std::numeric_limits<double>::infinity();
  const model::Box3 region = surface_of(inputs_).bounding_box().grown(stage_.allowance_mm);
  const verifier::RemovedSpace space =
      verifier::RemovedSpace(job_.stock, {&pass, 1}).with(assembly_of(pass, region));
  const verifier::CertificateRequest request{stage_.allowance_mm,
                                             gouge_mm_,
                                             unlimited,
                                             resolution_mm_,
                                             verifier::StageCheck().largest_cell_count,
                                             true};
  const auto control = watch_.control(stage_.name + ": proving a tilt");
  const verifier::Certificate found =
      certify(cells_, space, verifier::Side::gouge, nullptr, request, control);
  if (found.figure_mm.high <= gouge_mm_) return std::nullopt;
  std::string what = "the tool is not proven to spare the part";
  if (found.witness) {
    const model::Vec3& at = found.witness->place.point;
    what = "the tool cuts " + model::six_digits(found.figure_mm.low) + " mm into the part at (" +
           model::six_digits(at.x) + ", " + model::six_digits(at.y) + ", " +
           model::six_digits(at.z) + ")";
  }
  return what;
}

std::optional<std::string> TiltProof::against_process(const model::Pass& pass) const {
  for (const simulator::Finding& finding :
       process_findings(job_, inputs_, stage_, stock_, pass, watch_))
    if (fails(finding.kind))
      return "line " + std::to_string(finding.line) +
             " of its program: " + reports::description(finding.kind);
  return std::nullopt;
}

std::optional<std::string> TiltProof::against(const StageToCut& planned) const {
  const model::Pass pass{stage_.cutter, planned.path, {}, false, planned.axes};
  if (auto found = against_part(pass)) return found;
  return against_process(pass);
}

}  // namespace limitgauge::app
