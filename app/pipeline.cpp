#include "app/pipeline.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "app/output_files.h"
#include "app/stage_planner.h"
#include "app/stage_program.h"
#include "engine/model/machining_time.h"
#include "reports/process.h"
#include "reports/report.h"
#include "simulator/dexel_agreement.h"
#include "simulator/dexel_stock.h"
#include "simulator/process_check.h"
#include "verifier/verify.h"

namespace limitgauge::app {
namespace {

using verifier::Verdict;

/// Lines on which the two stock models are compared after each stage.
constexpr std::size_t kComparedLines = 4000;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::size_t peak_memory_bytes() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  constexpr std::size_t kUnit = 1024;  // Linux counts in kilobytes.
  return static_cast<std::size_t>(usage.ru_maxrss) * kUnit;
}

reports::StageResult stage_as_asked(const JobStage& asked) {
  reports::StageResult stage;
  stage.name = asked.name;
  stage.tool = asked.cutter.id;
  stage.cutter = asked.cutter;
  stage.program = asked.program_as_stated;
  stage.program_part = to_text(asked.part);
  stage.allowance_mm = asked.allowance_mm;
  stage.limits = asked.limits;
  if (!asked.plan) return stage;
  stage.strategy = strategy_name(asked.plan->cut.strategy);
  stage.step_mm = asked.plan->cut.step_mm;
  stage.tolerance_mm = asked.plan->cut.tolerance_mm;
  return stage;
}

/// Where the four parts meet: the state of one run between its stages.
class Bench {
 public:
  Bench(const Job& job, const RunInputs& inputs, const std::filesystem::path& folder,
        const RunOptions& options)
      : job_(job), inputs_(inputs), folder_(folder), options_(options), planner_(job, inputs) {}

  reports::RunResult run();

 private:
  model::RunControl control(const std::string& what) const;
  void run_stage(std::size_t index, reports::StageResult& stage);
  void make_path(std::size_t index, reports::StageResult::Ran& ran);
  double readings_within_mm(const JobStage& asked) const;
  model::Box3 near_surface(const JobStage& asked) const;
  void cut(const JobStage& asked, reports::StageResult::Ran& ran);
  void follow_process(const JobStage& asked, const simulator::Pass& pass,
                      reports::StageResult::Ran& ran);
  const simulator::StockAgreement& agreed(const JobStage& asked,
                                          const simulator::StockAgreement& found) const;
  void say_forecast(const JobStage& asked, const simulator::CutForecast& forecast) const;
  void let_go(reports::StageResult& stage);
  void measure(std::size_t index, reports::StageResult::Ran& ran);
  void finish_surface(reports::SurfaceResult& surface) const;
  void add_assumed(std::vector<std::string>& said) const;

  const Job& job_;
  const RunInputs& inputs_;
  const std::filesystem::path& folder_;
  const RunOptions& options_;
  StagePlanner planner_;
  std::size_t stage_ = 0;  ///< the one at work, counted from 1
  std::optional<simulator::StockModel> stock_;
  double volume_mm3_ = 0;
  std::optional<simulator::DexelStock> lines_;
  std::vector<verifier::Pass> passes_;
  std::vector<verifier::StockReading> readings_;
};

model::RunControl Bench::control(const std::string& what) const {
  options_.watch.phase({what, stage_, job_.stages.size()});
  model::RunControl control{options_.threads, options_.stop, options_.watch.progress};
  control.check();
  return control;
}

void Bench::make_path(std::size_t index, reports::StageResult::Ran& ran) {
  const JobStage& asked = job_.stages[index];
  const Stopwatch watch;
  PlannedStage planned = planner_.plan(index, passes_, control(asked.name + ": planning"));
  const std::filesystem::path folder = folder_ / asked.name;
  make_folder(folder);
  write_program_files(planned, folder);
  // The model of the surface has a time of its own.
  ran.plan_seconds = job_.stages[index].plan ? planned.path.seconds : watch.seconds();
  ran.planes = planned.path.planes;
  ran.sampling_interval_min = planned.path.sampling_interval_min;
  ran.sampling_interval_max = planned.path.sampling_interval_max;
  ran.sampling_intervals = std::move(planned.path.sampling_intervals);
  ran.path_memory_bytes = planned.path.memory_bytes;
  ran.ignored_words = std::move(planned.ignored_words);
  ran.program_text = std::make_shared<const std::string>(std::move(planned.program));
  ran.path = std::make_shared<const model::Toolpath>(std::move(planned.path.path));
  const model::ToolpathLengths sums = lengths(*ran.path, job_.rapid_mm_min);
  ran.cut_length_mm = sums.cut_mm;
  ran.rapid_length_mm = sums.rapid_mm;
  ran.machining_time_s = machining_time_s(
      *ran.path, {job_.rapid_mm_min, job_.acceleration_mm_s2, job_.junction_deviation_mm});
}

double Bench::readings_within_mm(const JobStage& asked) const {
  // Well beyond what a gate speaks of; the floor and the sides of the stock are far from the part.
  constexpr double kVoxels = 10;
  return kVoxels * stock_->voxel_mm() +
         2 * (asked.allowance_mm + std::max(asked.limits.gouge_mm, asked.limits.uncut_mm));
}

/// The box of the surface with room around it, and everything above it: a leftover may be as high
/// as the raw stock. Below, as far as holes are looked for.
model::Box3 Bench::near_surface(const JobStage& asked) const {
  model::Box3 box = inputs_.surface.bounding_box().grown(readings_within_mm(asked));
  box.high.z = std::max(box.high.z, model::bounding_box(job_.stock).high.z + stock_->voxel_mm());
  box.low.z = std::min(box.low.z, inputs_.surface.bounding_box().low.z - verifier::kStockSight_mm);
  return box;
}

void Bench::cut(const JobStage& asked, reports::StageResult::Ran& ran) {
  const Stopwatch watch;
  const simulator::Pass pass{asked.cutter, ran.path};
  follow_process(asked, pass, ran);
  say_forecast(asked, stock_->forecast(pass, control(asked.name + ": forecasting")));
  stock_ = std::move(*stock_).cut(pass, control(asked.name + ": cutting"));
  const double volume_mm3 = stock_->volume_mm3(control(asked.name + ": adding up"));
  ran.removed_volume_mm3 = volume_mm3_ - volume_mm3;
  volume_mm3_ = volume_mm3;
  ran.agreement = agreed(asked, compare_stocks(*lines_, *stock_, kComparedLines,
                                               control(asked.name + ": comparing the models")));
  readings_.clear();
  stock_->visit_surface_points(
      near_surface(asked),
      [this](std::span<const simulator::StockPoint> points) {
        for (const simulator::StockPoint& p : points)
          readings_.push_back({p.position, p.residual_mm});
      },
      control(asked.name + ": reading the stock"));
  ran.voxel_mm = stock_->voxel_mm();
  ran.tiles = stock_->tiles();
  ran.stock = stock_;
  ran.simulation_seconds = watch.seconds();
  ran.peak_memory_bytes = peak_memory_bytes();
}

/// What the shape that is left does not show: collisions and the like, and what each move took.
void Bench::follow_process(const JobStage& asked, const simulator::Pass& pass,
                           reports::StageResult::Ran& ran) {
  simulator::ProcessLimits limits;
  limits.tolerance_mm = inputs_.settings.contact_tolerance_mm;
  limits.near_miss_mm = job_.near_miss_mm;
  limits.travel_mm = job_.travel_mm;
  limits.fixtures = inputs_.fixtures;
  ran.process =
      check_process(*stock_, pass, limits, control(asked.name + ": checking the process"));
  simulator::DexelStock::Cut after =
      lines_->cut(pass, control(asked.name + ": following the removal"));
  lines_ = std::move(after.stock);
  ran.removal = std::move(after.removal);
}

void Bench::say_forecast(const JobStage& asked, const simulator::CutForecast& forecast) const {
  constexpr double kMib = 1024.0 * 1024.0;
  std::ostringstream line;
  line << asked.name << ": cutting is forecast to take " << forecast.seconds << " s and "
       << std::lround(forecast.bytes / kMib) << " MiB";
  if (forecast.tiled) line << ", tile by tile";
  options_.watch.note(line.str());
}

/// Two stock models that contradict each other are a bug in one of them: no verdict rests on that.
const simulator::StockAgreement& Bench::agreed(const JobStage& asked,
                                               const simulator::StockAgreement& found) const {
  if (std::max(found.worst_end_mm, found.worst_side_mm) <= simulator::kAgreement_mm) return found;
  std::ostringstream what;
  what << asked.name << ": the two stock models differ by "
       << std::max(found.worst_end_mm, found.worst_side_mm) << " mm at (" << found.worst_at.x
       << ", " << found.worst_at.y << ", " << found.worst_at.z << "); please report this";
  throw verifier::InstrumentDisagreement(what.str());
}

/// What only the stage's files needed.
void Bench::let_go(reports::StageResult& stage) {
  stage.ran->stock.reset();
  stage.ran->removal.moves = {};
}

std::vector<verifier::ProcessFault> process_faults(std::span<const simulator::Finding> findings) {
  std::vector<verifier::ProcessFault> faults;
  for (const simulator::FindingKind kind : reports::kFindingKinds)
    if (fails(kind)) faults.push_back({reports::words_for(kind), reports::count(findings, {kind})});
  return faults;
}

void Bench::measure(std::size_t index, reports::StageResult::Ran& ran) {
  const JobStage& asked = job_.stages[index];
  passes_.push_back({asked.cutter, ran.path});
  verifier::StageCheck check;
  check.allowance_mm = asked.allowance_mm;
  check.limits = asked.limits;
  check.resolution_mm = inputs_.settings.resolution_mm[index];
  check.voxel_mm = stock_->voxel_mm();
  check.readings_within_mm = readings_within_mm(asked);
  ran.deviation = measure_stage(inputs_.surface, job_.stock, passes_, readings_, check,
                                control(asked.name + ": measuring"));
}

void Bench::run_stage(std::size_t index, reports::StageResult& stage) {
  const Stopwatch watch;
  stage_ = index + 1;
  reports::StageResult::Ran& ran = stage.ran.emplace();
  make_path(index, ran);
  cut(job_.stages[index], ran);
  measure(index, ran);
  stage.decision = decide(ran.deviation, stage.limits, process_faults(ran.process));
  reports::StageFiles files = write_stage_files(
      stage, folder_, {job_.pictures, control(stage.name + ": writing"), job_.rapid_mm_min});
  ran.surface = files.surface;
  ran.path_view = std::move(files.path_view);
  if (job_.pictures) stage.pictures = std::move(files.pictures);
  let_go(stage);
  stage.seconds = watch.seconds();
  std::ostringstream line;
  line << stage.name << ": " << name(stage.decision.verdict) << "; planned "
       << ran.path->moves.size() << " moves in " << ran.plan_seconds << " s, cut in "
       << ran.simulation_seconds << " s, measured in " << ran.deviation.seconds << " s";
  options_.watch.note(line.str());
}

void Bench::finish_surface(reports::SurfaceResult& surface) const {
  const std::optional<engine::surface::ModelFigures> figures = planner_.figures();
  if (!figures) return;
  surface.depth_min = figures->depth_min;
  surface.depth_max = figures->depth_max;
  surface.depths = figures->depths;
  surface.cell_bytes_counted = figures->cell_bytes_counted;
  surface.cell_bytes_allocated = figures->cell_bytes_allocated;
  surface.seconds = figures->seconds;
  surface.memory_bytes = figures->memory_bytes;
}

/// What the reader of programs took for granted; stages that share a program share it.
void Bench::add_assumed(std::vector<std::string>& said) const {
  for (const std::optional<ForeignPath>& program : inputs_.programs) {
    if (!program) continue;
    for (const std::string& assumed : program->assumed)
      if (std::find(said.begin(), said.end(), assumed) == said.end()) said.push_back(assumed);
  }
}

reports::SurfaceResult surface_as_read(const Job& job, const RunInputs& inputs) {
  reports::SurfaceResult surface;
  surface.cage = job.cage_as_stated;
  surface.summary = summarize(inputs.cage);
  surface.rules = inputs.surface.rules();
  surface.bbox_mm = inputs.surface.bounding_box();
  surface.area_mm2 = inputs.surface.area_mm2();
  return surface;
}

/// Widest range of sampling intervals over the stages that were planned.
void join_sampling(reports::RunResult& result) {
  bool first = true;
  for (const reports::StageResult& stage : result.stages) {
    if (!stage.ran || stage.strategy.empty()) continue;
    const auto& ran = *stage.ran;
    int& low = result.surface.sampling_interval_min;
    int& high = result.surface.sampling_interval_max;
    low = first ? ran.sampling_interval_min : std::min(low, ran.sampling_interval_min);
    high = first ? ran.sampling_interval_max : std::max(high, ran.sampling_interval_max);
    first = false;
  }
}

reports::RunResult Bench::run() {
  reports::RunResult result;
  result.job = job_.name;
  result.created = options_.created;
  result.version = LIMITGAUGE_VERSION;
  result.threads = options_.threads;
  result.raw_stock = job_.stock;
  result.surface = surface_as_read(job_, inputs_);
  result.assumptions = assumptions(job_, inputs_.settings);
  add_assumed(result.assumptions);
  result.program_frame = job_.program_frame;
  result.machine = job_.machine;
  result.published = job_.published;
  result.inputs = inputs_.files;
  for (const JobStage& asked : job_.stages) result.stages.push_back(stage_as_asked(asked));
  stock_.emplace(job_.stock, inputs_.settings.voxel_mm, inputs_.settings.memory_limit_bytes,
                 control("raw stock"));
  volume_mm3_ = stock_->volume_mm3(control("raw stock"));
  lines_.emplace(job_.stock, inputs_.settings.line_spacing_mm);
  result.verdict = Verdict::pass;
  for (std::size_t i = 0; i < result.stages.size() && result.verdict == Verdict::pass; ++i) {
    run_stage(i, result.stages[i]);
    result.verdict = result.stages[i].decision.verdict;
  }
  finish_surface(result.surface);
  join_sampling(result);
  return result;
}

}  // namespace

reports::RunResult run_job(const Job& job, const RunInputs& inputs,
                           const std::filesystem::path& folder, const RunOptions& options) {
  return Bench(job, inputs, folder, options).run();
}

void plan_job(const Job& job, const RunInputs& inputs, const std::filesystem::path& folder,
              const RunOptions& options) {
  StagePlanner planner(job, inputs);
  std::vector<verifier::Pass> passes;
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    const std::string& name = job.stages[i].name;
    options.watch.phase({name + ": planning", i + 1, job.stages.size()});
    PlannedStage planned =
        planner.plan(i, passes, {options.threads, options.stop, options.watch.progress});
    make_folder(folder / name);
    write_program_files(planned, folder / name);
    reports::write_toolpath_vtp(planned.path.path, folder / name / "toolpath.vtp");
    options.watch.note(name + ": " + std::to_string(planned.path.path.moves.size()) + " moves");
    passes.push_back({job.stages[i].cutter,
                      std::make_shared<const model::Toolpath>(std::move(planned.path.path))});
  }
}

void write_report(const reports::RunResult& result, const std::filesystem::path& folder) {
  using Writer = void (*)(const reports::RunResult&, std::ostream&);
  const auto write = [&](const char* file, Writer writer) {
    write_file(folder / file, [&](std::ostream& out) { writer(result, out); });
  };
  write("report.html", reports::write_html);
  write("junit.xml", reports::write_junit);
  write("findings.sarif", reports::write_sarif);
  write("findings.csv", reports::write_findings_csv);
  // Last: what looks for a finished run looks for this file.
  write("result.json", reports::write_result_json);
}

}  // namespace limitgauge::app
