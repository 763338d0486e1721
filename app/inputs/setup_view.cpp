#include "app/inputs/setup_view.h"

#include <algorithm>

#include "app/inputs/input_checksums.h"
#include "app/inputs/part_fit.h"
#include "app/inputs/run_forecast.h"
#include "app/inputs/surface_witness.h"
#include "app/job/setup_frame.h"
#include "model/base/coordinate_limit.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace {

void require_near(const char* what, const model::Box3& box, const model::Setup& setup) {
  if (!model::is_near(box))
    throw model::InputError(
        {},
        "setup \"" + setup.name + "\" has the " + what + " reach to " + model::farthest_words(box),
        model::kFarthestExpected);
}

model::Stock turned_stock(const Job& job, const model::Setup& setup) {
  model::Stock stock = model::turned(job.stock, setup.from_part);
  require_near("stock", model::bounding_box(stock), setup);
  return stock;
}

}  // namespace

Job in_setup(const Job& job, std::size_t setup) {
  const JobSetup& at = job.setups[setup];
  Job out = job;
  out.at_setup = setup;
  out.stock = turned_stock(job, at.setup);
  const std::size_t stated = at.turned ? at.turned->of : setup;
  std::erase_if(out.fixtures, [&](const JobFixture& fixture) {
    return fixture.setup && *fixture.setup != stated;
  });
  out.machine = machine_in_setup(job, setup);
  if (!at.turned) return out;
  for (JobFixture& fixture : out.fixtures)
    if (!fixture.mount.with_tool())
      fixture.turned = turned_body(out, fixture.mount, at.turned->angles_deg);
  return out;
}

JobSurface turned(const JobSurface& surface, const model::Pose& from_part,
                  const model::RunControl& control) {
  if (from_part == model::Pose{}) return surface;
  model::Cage cage = turned(surface.cage, from_part);
  if (surface.mesh) {
    model::TriangleMesh mesh;
    mesh.vertices = cage.vertices;
    for (model::Index f = 0; f < cage.face_count(); ++f) {
      const auto face = cage.face(f);
      mesh.triangles.push_back({static_cast<std::uint32_t>(face[0]),
                                static_cast<std::uint32_t>(face[1]),
                                static_cast<std::uint32_t>(face[2])});
    }
    verifier::ReferenceSurface facets(mesh, control);
    witness::Agreement witness = witnessed_facets(cage, facets);
    return {std::move(cage), std::move(facets), std::move(witness), surface.mesh};
  }
  verifier::ReferenceSurface exact(cage, control);
  witness::Agreement witness = witnessed(cage, exact);
  return {std::move(cage), std::move(exact), std::move(witness), std::nullopt};
}

const Job& job_of_stage(const Job& job, const RunInputs& inputs, std::size_t stage) {
  return inputs.setups.empty() ? job : inputs.setups[job.stages[stage].setup]->job;
}

const RunInputs& inputs_of_stage(const Job& job, const RunInputs& inputs, std::size_t stage) {
  return inputs.setups.empty() ? inputs : inputs.setups[job.stages[stage].setup]->inputs;
}

RunInputs load_in_setups(const Job& job, const RunTerms& terms, std::optional<JobSurface> design,
                         const model::RunControl& control) {
  require_fit(job, design ? &design->cage : nullptr);
  RunInputs all;
  all.terms = terms;
  all.settings = choose_settings(job, design ? design->surface.bounding_box() : model::Box3(),
                                 terms.memory_limit_bytes);
  all.programs.resize(job.stages.size());
  std::vector<std::shared_ptr<SetupView>> views;
  for (std::size_t k = 0; k < job.setups.size(); ++k) {
    control.check();
    Job at = in_setup(job, k);
    const model::Setup& setup = job.setups[k].setup;
    std::optional<JobSurface> surface;
    if (design) surface = turned(*design, setup.from_part, control);
    if (surface) require_near("part", surface->surface.bounding_box(), setup);
    RunInputs inputs = load_inputs(at, terms, std::move(surface));
    for (std::size_t i = 0; i < job.stages.size(); ++i) {
      if (job.stages[i].setup != k) continue;
      all.programs[i] = inputs.programs[i];
      all.settings.floor_z_mm[i] = inputs.settings.floor_z_mm[i];
    }
    views.push_back(std::make_shared<SetupView>(SetupView{std::move(at), std::move(inputs)}));
  }
  tell_offsets_left(all.programs);
  all.settings.stock_limit_bytes =
      stock_limit_bytes(scale_of(job, design ? &design->surface : nullptr, all.programs, terms));
  for (const auto& view : views)
    view->inputs.settings.stock_limit_bytes = all.settings.stock_limit_bytes;
  all.setups.assign(views.begin(), views.end());
  all.design = std::move(design);
  all.files = input_checksums(job);
  return all;
}

}  // namespace limitgauge::app
