#include "app/run/result_parts.h"

#include <algorithm>

#include "app/inputs/mesh_target.h"
#include "model/text/number_text.h"
#include "reports/run/report.h"

namespace limitgauge::app {
namespace {

reports::StageResult stage_as_asked(const JobStage& asked, bool has_design) {
  reports::StageResult stage;
  stage.name = asked.name;
  stage.tool = asked.cutter.id;
  stage.cutter = asked.cutter;
  stage.program = asked.program_as_stated;
  stage.program_part = to_text(asked.part);
  const bool is_stretch = asked.piece && !asked.piece->turns_while_cutting();
  if (is_stretch)
    stage.stretch = {asked.piece->stage, asked.piece->number, asked.piece->count,
                     asked.piece->angles};
  if (is_stretch)
    stage.program_part += (stage.program_part.empty() ? "" : ", ") + to_text(*asked.piece);
  if (has_design) stage.allowance_mm = asked.allowance_mm;
  stage.limits = asked.limits;
  if (!asked.plan) return stage;
  stage.strategy = strategy_name(asked.plan->cut.strategy);
  stage.step_mm = asked.plan->cut.step_mm;
  stage.tolerance_mm = asked.plan->cut.tolerance_mm;
  return stage;
}

std::string start_text(const model::Vec3& at_mm, bool has_design) {
  return "programs start with the tip at (" + model::shortest(at_mm.x) + ", " +
         model::shortest(at_mm.y) + ", " + model::shortest(at_mm.z) +
         ") mm of their frame (default: its zero in X and Y; in Z above stock, " +
         (has_design ? "part, " : "") +
         "fixtures and every height that a program names, by the clearance)";
}

/// Where the programs start: the same for all of them, but for those that say it by themselves.
void add_start(const RunInputs& inputs, reports::RunResult& result) {
  for (const std::optional<ForeignPath>& program : inputs.programs) {
    if (!program) continue;
    const model::ProgramStart& start = program->start;
    if (!result.program_start || start.assumed) result.program_start = start;
    if (!start.assumed) continue;
    result.assumptions.push_back(start_text(start.at_mm, inputs.design.has_value()));
    return;
  }
}

/// What the reader of programs took for granted; stages that share a program share it.
void add_assumed(const RunInputs& inputs, std::vector<std::string>& said) {
  for (const std::optional<ForeignPath>& program : inputs.programs) {
    if (!program) continue;
    const auto add = [&](const std::string& assumed) {
      if (std::find(said.begin(), said.end(), assumed) == said.end()) said.push_back(assumed);
    };
    for (const std::string& assumed : program->assumed) add(assumed);
    if (!program->unended.empty()) add(program->unended);
  }
}

reports::SurfaceResult surface_as_read(const JobDesign& design, const JobSurface& read) {
  reports::SurfaceResult surface;
  surface.cage = design.as_stated;
  surface.mesh = read.mesh;
  surface.summary = summarize(read.cage);
  surface.rules = read.surface.rules();
  surface.bbox_mm = read.surface.bounding_box();
  surface.area_mm2 = read.surface.area_mm2();
  surface.witness = read.witness;
  return surface;
}

/// What a mesh as a design is taken to be.
void add_facets(const reports::SurfaceResult& surface, std::vector<std::string>& said) {
  said.push_back(
      "the facets of mesh " + surface.cage +
      " are the design: how far they lie from the shape that they were made from is not known here "
      "and not part of any figure");
  if (surface.summary.boundary_edges > 0)
    said.push_back("mesh " + surface.cage +
                   " is open: the side from which the corners of its triangles go round "
                   "counter-clockwise is taken to be machined");
  if (surface.mesh->dropped_triangles > 0)
    said.push_back("mesh " + surface.cage + ": " + std::to_string(surface.mesh->dropped_triangles) +
                   " triangles with two corners in one point were left out");
}

void add_design(const Job& job, const RunInputs& inputs, reports::RunResult& result) {
  if (!inputs.design) return;
  result.surface = surface_as_read(job.design.value(), *inputs.design);
  const reports::SurfaceResult& surface = *result.surface;
  if (surface.mesh) {
    add_facets(surface, result.assumptions);
    return;
  }
  const std::string head = "cage " + surface.cage + ": ";
  if (const std::string like = mesh_like_warning(surface.summary); !like.empty())
    result.assumptions.push_back(head + like);
  if (!inputs.design->cage.ends_in_line)
    result.assumptions.push_back(head + "its last line has no line end; taken to be whole");
}

/// Widest range of sampling intervals over the stages that were planned.
void join_sampling(const std::vector<reports::StageResult>& stages,
                   reports::SurfaceResult& surface) {
  bool first = true;
  for (const reports::StageResult& stage : stages) {
    if (!stage.ran || stage.strategy.empty()) continue;
    const auto& ran = *stage.ran;
    int& low = surface.sampling_interval_min;
    int& high = surface.sampling_interval_max;
    low = first ? ran.sampling_interval_min : std::min(low, ran.sampling_interval_min);
    high = first ? ran.sampling_interval_max : std::max(high, ran.sampling_interval_max);
    first = false;
  }
}

/// The word of `axis` in [[fixture]]; none for what lies with the part.
std::optional<std::string> mount_word(const FixtureMount& mount) {
  switch (mount.kind) {
    case FixtureMount::Kind::part:
      return std::nullopt;
    case FixtureMount::Kind::machine:
      return "none";
    case FixtureMount::Kind::spindle:
      return "spindle";
    default:
      return std::string(1, *mount.axis);
  }
}

std::vector<reports::record::CheckedFixture> checked_fixtures(const Job& job) {
  std::vector<reports::record::CheckedFixture> out;
  for (const JobFixture& f : job.fixtures) {
    std::optional<std::string> setup;
    if (f.setup && has_setups(job)) setup = job.setups[*f.setup].setup.name;
    out.push_back({f.name, f.file_as_stated, f.translate_mm, setup, mount_word(f.mount)});
  }
  return out;
}

std::vector<reports::record::RotaryAxis> rotary_axes(const Job& job) {
  std::vector<reports::record::RotaryAxis> out;
  if (!job.machine.kinematics) return out;
  const auto& axes = job.machine.kinematics->axes;
  for (std::size_t i = 0; i < axes.size(); ++i)
    out.push_back({std::string(1, axes[i].word), job.machine.kinematics->is_head(i),
                   axes[i].direction, axes[i].point_mm, axes[i].low_deg, axes[i].high_deg});
  return out;
}

}  // namespace

reports::RunResult result_as_asked(const Job& job, const RunInputs& inputs,
                                   const RunOptions& options) {
  reports::RunResult result;
  result.job = job.name;
  result.label = options.label;
  result.created = options.created;
  result.version = LIMITGAUGE_VERSION;
  result.threads = options.threads;
  result.raw_stock = job.stock;
  result.tolerances = job.tolerances;
  result.overrides = job.overrides;
  result.process_limits = {inputs.settings.contact_tolerance_mm, near_miss_mm(job), job.travel_mm,
                           checked_fixtures(job), rotary_axes(job)};
  result.assumptions = assumptions(job, inputs.settings);
  add_design(job, inputs, result);
  add_start(inputs, result);
  add_assumed(inputs, result.assumptions);
  result.program_frame = job.program_frame;
  result.machine = job.machine;
  result.published = job.published;
  result.inputs = inputs.files;
  if (has_setups(job))
    for (const JobSetup& at : job.setups) result.setups.push_back(at.setup);
  for (const JobStage& asked : job.stages) {
    result.stages.push_back(stage_as_asked(asked, job.design.has_value()));
    result.stages.back().setup = job.setups[asked.setup].setup;
  }
  return result;
}

void take_up(const RecordedStage& recorded, reports::StageResult& stage) {
  stage.recorded = recorded.json;
  stage.decision.verdict = recorded.verdict;
  reports::StageRun& ran = stage.ran.emplace();
  ran.path = recorded.path;
  ran.axes = recorded.axes;
  ran.program_text = recorded.program_text;
  ran.sampling_interval_min = recorded.sampling_interval_min;
  ran.sampling_interval_max = recorded.sampling_interval_max;
}

std::vector<RecordedStage> recorded_stages(const reports::RunResult& result) {
  std::vector<RecordedStage> stages;
  for (std::size_t i = 0; i < result.stages.size() && result.stages[i].ran; ++i) {
    const reports::StageRun& ran = *result.stages[i].ran;
    stages.push_back({std::make_shared<const std::string>(reports::recorded_stage(result, i)),
                      ran.path, ran.program_text, ran.sampling_interval_min,
                      ran.sampling_interval_max, result.stages[i].decision.verdict, ran.axes});
  }
  return stages;
}

void finish_surface(reports::RunResult& result,
                    const std::optional<engine::surface::ModelFigures>& figures) {
  if (!result.surface) return;
  reports::SurfaceResult& surface = *result.surface;
  join_sampling(result.stages, surface);
  if (!figures) return;
  surface.depth_min = figures->depth_min;
  surface.depth_max = figures->depth_max;
  surface.depths = figures->depths;
  surface.cell_bytes_counted = figures->cell_bytes_counted;
  surface.cell_bytes_allocated = figures->cell_bytes_allocated;
  surface.seconds = figures->seconds;
  surface.memory_bytes = figures->memory_bytes;
}

}  // namespace limitgauge::app
