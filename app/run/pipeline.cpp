#include "app/run/pipeline.h"

#include <new>
#include <sstream>
#include <utility>

#include "app/inputs/run_forecast.h"
#include "app/inputs/surface_witness.h"
#include "app/run/cut_stock.h"
#include "app/run/result_parts.h"
#include "app/run/run_setups.h"
#include "app/run/stage_check.h"
#include "app/run/stage_prefix.h"
#include "app/run/stage_program.h"
#include "app/run/stock_probe.h"
#include "app/run/tilt_proof.h"
#include "model/base/clock.h"
#include "model/base/error.h"
#include "model/base/memory.h"
#include "model/base/output_file.h"
#include "model/part/machining_time.h"
#include "model/text/number_text.h"
#include "reports/run/process.h"
#include "reports/run/report.h"

namespace limitgauge::app {
namespace {

using verifier::Verdict;

/// Where the four parts meet: the state of one run between its stages.
class Bench {
 public:
  Bench(const Job& job, const RunInputs& inputs, const std::filesystem::path& folder,
        const RunOptions& options, const Resumption& resumption)
      : job_(job),
        inputs_(inputs),
        folder_(folder),
        options_(options),
        resumption_(resumption),
        from_(resumption.from ? *resumption.from : StagePrefix()),
        setups_(job, inputs, from_.model) {}

  reports::RunResult run();

 private:
  model::RunControl control(const std::string& what) const { return watch().control(what); }
  StageWatch watch() const { return {options_, stage_, job_.stages.size()}; }
  void begin(reports::RunResult& result);
  void say_forecast();
  void run_stage(std::size_t index, reports::StageResult& stage);
  StageToCut planned(std::size_t index);
  void make_path(std::size_t index, reports::StageRun& ran);
  bool stays(std::size_t index, reports::StageRun& ran) const;
  void cut(std::size_t index, reports::StageRun& ran);
  void measure(std::size_t index, reports::StageRun& ran);
  std::vector<std::string> names_up_to(std::size_t index) const;
  void write_files(std::size_t index, reports::StageResult& stage) const;
  void hand_over(const reports::RunResult& result) const;
  std::optional<engine::surface::ModelFigures> figures() const;
  void enter_setup(std::size_t index);

  const Job& job_;
  const RunInputs& inputs_;
  const std::filesystem::path& folder_;
  const RunOptions& options_;
  const Resumption& resumption_;
  StagePrefix from_;
  RunSetups setups_;
  std::size_t stage_ = 0;  ///< the one at work, counted from 1
  std::optional<CutStock> stock_;
  bool passed_by_ = false;    ///< by the stage at work
  std::size_t stock_of_ = 0;  ///< a stage in whose setup's frame the stock is
};

bool has_auto_tilt(const JobStage& stage) {
  return stage.plan && stage.plan->cut.lean && stage.plan->tilt_is_auto;
}

/// The stock as it lies in the machine for a stage.
void Bench::enter_setup(std::size_t index) {
  const std::size_t before = std::exchange(stock_of_, index);
  if (setups_.setup_of(before) == setups_.setup_of(index)) return;
  stock_ = turned_over(setups_.job_at(index), setups_.inputs_at(index).settings, *stock_,
                       {setups_.passes_at(index), setups_.turn(before, index)}, watch());
}

/// A tilt "auto" is proven on the stock as it lies in the stage's setup.
StageToCut Bench::planned(std::size_t index) {
  const JobStage& asked = job_.stages[index];
  std::optional<TiltProof> proof;
  CollisionProof asks;
  if (has_auto_tilt(asked)) {
    enter_setup(index);
    proof.emplace(setups_.job_at(index), setups_.inputs_at(index), index, stock_->stock, watch());
    asks = [&proof](const StageToCut& ready) { return proof->against(ready); };
  }
  return setups_.planner_at(index).plan(index, setups_.passes_at(index),
                                        control(asked.name + ": planning"), asks);
}

void Bench::make_path(std::size_t index, reports::StageRun& ran) {
  const JobStage& asked = job_.stages[index];
  const model::Stopwatch watch;
  StageToCut ready = planned(index);
  if (options_.stage_files) {
    model::make_folder(folder_ / asked.name);
    write_program_files(ready, folder_ / asked.name);
  }
  // The model of the surface has a time of its own.
  ran.plan_seconds = asked.plan ? ready.figures.seconds : watch.seconds();
  ran.planes = ready.figures.planes;
  ran.sampling_interval_min = ready.figures.sampling_interval_min;
  ran.sampling_interval_max = ready.figures.sampling_interval_max;
  ran.sampling_intervals = std::move(ready.figures.sampling_intervals);
  ran.path_memory_bytes = ready.figures.memory_bytes;
  ran.ignored_words = std::move(ready.ignored_words);
  ran.program_text = std::move(ready.program);
  ran.path = std::move(ready.path);
  ran.axes = std::move(ready.axes);
  if (ready.lean)
    ran.lean = {ready.lean->lead_deg, ready.lean->tilt_deg,
                ready.lean->from == engine::strategy::LeanFrom::surface};
  const model::ToolpathLengths sums = lengths(*ran.path, job_.rapid_mm_min);
  ran.cut_length_mm = sums.cut_mm;
  ran.rapid_length_mm = sums.rapid_mm;
  ran.machining_time_s = machining_time_s(
      *ran.path, {job_.rapid_mm_min, job_.acceleration_mm_s2, job_.junction_deviation_mm});
}

/// Where a stretch that only positions passes the stock by, the stock stays as it lay: most
/// programs go home between two orientations. Not without a design, whose page shows it in each
/// stretch.
bool Bench::stays(std::size_t index, reports::StageRun& ran) const {
  return setups_.inputs_at(index).design &&
         passes_by(setups_.job_at(index), setups_.inputs_at(index), job_.stages[index], *stock_,
                   watch(), ran);
}

void Bench::cut(std::size_t index, reports::StageRun& ran) {
  const model::Stopwatch stopwatch;
  passed_by_ = stays(index, ran);
  if (!passed_by_) {
    enter_setup(index);
    CutStock before = std::move(*stock_);
    stock_.reset();
    stock_ = cut_stage(setups_.job_at(index), setups_.inputs_at(index), job_.stages[index],
                       std::move(before), watch(), ran);
  }
  ran.stock_to_part = job_.setups[setups_.setup_of(stock_of_)].setup.from_part.inverse();
  ran.simulation_seconds = stopwatch.seconds();
  ran.peak_memory_bytes = model::process_peak_bytes();
}

/// Whether what a stretch of a stage's program leaves is measured: the one that has the stage's
/// name, and of the others those that have a limit. One that passes the stock by leaves what it
/// found.
bool is_measured(const JobStage& stage) {
  return !stage.piece || stage.name == stage.piece->stage || stage.limits.has_gouge;
}

std::vector<verifier::ProcessFault> process_faults(std::span<const simulator::Finding> findings) {
  std::vector<verifier::ProcessFault> faults;
  for (const simulator::FindingKind kind : reports::kFindingKinds) {
    if (!fails(kind)) continue;
    verifier::ProcessFault fault{reports::description(kind), reports::moves_with(findings, kind)};
    for (const simulator::Finding& f : findings)
      if (f.kind == kind && (!fault.worst || f.depth_mm > fault.worst->depth_mm))
        fault.worst = {f.point, f.line, f.depth_mm};
    // A missing feed meets nothing, as a rule.
    fault.is_open =
        fault.worst && fault.worst->depth_mm == 0 && kind != simulator::FindingKind::feed_missing;
    faults.push_back(std::move(fault));
  }
  return faults;
}

void Bench::measure(std::size_t index, reports::StageRun& ran) {
  const JobStage& asked = job_.stages[index];
  setups_.add(ran.path, ran.axes);
  const RunInputs& inputs = setups_.inputs_at(index);
  if (!inputs.design || passed_by_ || !is_measured(asked)) return;
  const model::Stock& raw_stock = setups_.job_at(index).stock;
  const std::vector<verifier::Pass> passes = setups_.passes_at(index);
  const verifier::StageCheck check = stage_check(job_, inputs, index);
  const auto workers = options_.share ? options_.share(passes) : nullptr;
  const StockRayProbe probe(stock_->stock, &raw_stock);
  ran.deviation = measure_stage(inputs.design->surface, raw_stock, passes, &probe, check,
                                control(asked.name + ": measuring"), workers.get());
  ran.deviation->budget.push_back(budget_term(inputs.design->witness));
}

/// For lines of the programs of earlier stages.
std::vector<std::string> Bench::names_up_to(std::size_t index) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i <= index; ++i) names.push_back(job_.stages[i].name);
  return names;
}

void Bench::write_files(std::size_t index, reports::StageResult& stage) const {
  const std::vector<verifier::Pass> passes = setups_.passes_at(index);
  reports::StageFiles files =
      write_stage_files(stage, folder_,
                        {job_.pictures, control(stage.name + ": writing"), job_.rapid_mm_min,
                         job_.stock_surface, passes, setups_.inputs_at(index).design.has_value()});
  stage.ran->surface = files.surface;
  stage.ran->path_view = std::move(files.path_view);
  stage.ran->stock_view = std::move(files.stock_view);
  if (job_.pictures) stage.pictures = std::move(files.pictures);
}

void Bench::run_stage(std::size_t index, reports::StageResult& stage) {
  const model::Stopwatch watch;
  stage_ = index + 1;
  reports::StageRun& ran = stage.ran.emplace();
  make_path(index, ran);
  model::return_freed_memory();
  cut(index, ran);
  model::return_freed_memory();
  measure(index, ran);
  if (passed_by_) stage.limits = {};
  note_fixtures(setups_.job_at(index), setups_.inputs_at(index), ran);
  to_part_frame(ran, stage.setup.from_part.inverse());
  model::return_freed_memory();
  const std::vector<verifier::ProcessFault> faults = process_faults(ran.process);
  stage.decision = ran.deviation ? decide(*ran.deviation, stage.limits, faults, names_up_to(index))
                                 : verifier::decide(faults);
  if (options_.stage_files) {
    write_files(index, stage);
  } else if (ran.deviation) {
    ran.deviation->field = {};
  }
  // What only the stage's files needed.
  ran.stock.reset();
  ran.removal.moves = {};
  stage.seconds = watch.seconds();
  std::ostringstream line;
  line << stage.name << ": " << name(stage.decision.verdict) << "; planned "
       << ran.path->moves.size() << " moves in " << ran.plan_seconds << " s, cut in "
       << ran.simulation_seconds << " s";
  if (ran.deviation) line << ", measured in " << ran.deviation->seconds << " s";
  options_.watch.note(line.str());
}

std::optional<engine::surface::ModelFigures> Bench::figures() const {
  const auto built = setups_.figures();
  return built ? built : from_.figures;
}

/// The stages that are there, and what stands after them.
void Bench::begin(reports::RunResult& result) {
  for (std::size_t i = 0; i < from_.stages.size(); ++i) {
    take_up(from_.stages[i], result.stages[i]);
    result.verdict = from_.stages[i].verdict;
    setups_.add(from_.stages[i].path, from_.stages[i].axes);
    stock_of_ = i;
  }
  if (result.verdict != Verdict::pass) return;
  stock_ = from_.stages.empty()
               ? uncut_stock(setups_.job_at(0), setups_.inputs_at(0).settings, watch())
               : std::move(from_.stock);
  say_forecast();
}

/// Of the whole process, before anything is planned or cut.
void Bench::say_forecast() {
  const auto& built = setups_.planner_at(0).expected_model(control("model of the surface"));
  const RunScale scale = scale_of(job_, inputs_, built, stock_->stock);
  options_.watch.note("the run is forecast to take " + model::in_mib(forecast_bytes(scale)) +
                      " at its peak; allowed are " +
                      model::in_mib(static_cast<double>(inputs_.terms.memory_limit_bytes)));
}

void Bench::hand_over(const reports::RunResult& result) const {
  if (resumption_.after_stage)
    resumption_.after_stage({recorded_stages(result), figures(), setups_.first_model(), stock_});
}

reports::RunResult Bench::run() {
  reports::RunResult result = result_as_asked(job_, inputs_, options_);
  result.verdict = Verdict::pass;
  begin(result);
  for (std::size_t i = from_.stages.size();
       i < result.stages.size() && result.verdict == Verdict::pass; ++i) {
    run_stage(i, result.stages[i]);
    result.verdict = result.stages[i].decision.verdict;
    hand_over(result);
  }
  finish_surface(result, figures());
  return result;
}

}  // namespace

namespace {

/// Whatever took the last of it, in whatever thread: what the user can do is the same.
template <class Work>
auto within_memory(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    model::return_freed_memory();
    throw model::ResourceError(
        "limitgauge: error: out of memory, " +
        model::in_mib(static_cast<double>(model::process_peak_bytes())) +
        " were in use; a coarser voxel, fewer moves or more memory would do");
  }
}

}  // namespace

reports::RunResult run_job(const Job& job, const RunInputs& inputs,
                           const std::filesystem::path& folder, const RunOptions& options,
                           const Resumption& resumption) {
  return within_memory([&] { return Bench(job, inputs, folder, options, resumption).run(); });
}

namespace {

/// Of a tilt "auto": the stock that it is proven on is cut by all stages before it.
StageToCut planned_stage(RunSetups& setups, std::size_t index, const RunOptions& options) {
  const Job& job = setups.job_at(index);
  const RunInputs& inputs = setups.inputs_at(index);
  const std::vector<model::Pass> before = setups.passes_at(index);
  const model::RunControl control{options.threads, options.stop, options.watch.progress};
  if (!has_auto_tilt(job.stages[index]))
    return setups.planner_at(index).plan(index, before, control);
  const StageWatch watch{options, index + 1, job.stages.size()};
  const CutStock stock =
      cut_again(uncut_stock(job, inputs.settings, watch), before, inputs.settings, watch);
  const TiltProof proof(job, inputs, index, stock.stock, watch);
  return setups.planner_at(index).plan(
      index, before, control, [&](const StageToCut& ready) { return proof.against(ready); });
}

}  // namespace

void plan_job(const Job& job, const RunInputs& inputs, const std::filesystem::path& folder,
              const RunOptions& options) {
  RunSetups setups(job, inputs);
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    const std::string& name = job.stages[i].name;
    options.watch.phase({name + ": planning", i + 1, job.stages.size()});
    const StageToCut ready = planned_stage(setups, i, options);
    model::return_freed_memory();
    model::make_folder(folder / name);
    write_program_files(ready, folder / name);
    const model::Pose to_part = job.setups[setups.setup_of(i)].setup.from_part.inverse();
    const std::optional<model::ToolAxes> axes =
        ready.axes ? std::optional(turned(*ready.axes, to_part)) : std::nullopt;
    reports::write_toolpath_vtp(turned(*ready.path, to_part), folder / name / "toolpath.vtp", {},
                                {}, axes ? &*axes : nullptr);
    options.watch.note(name + ": " + std::to_string(ready.path->moves.size()) + " moves" +
                       (ready.lean ? ", tilt " + model::shortest(ready.lean->tilt_deg) : ""));
    setups.add(ready.path, ready.axes);
  }
}

void write_report(const reports::RunResult& result, const std::filesystem::path& folder,
                  unsigned threads) {
  using Writer = void (*)(const reports::RunResult&, std::ostream&);
  const auto write = [&](const char* file, Writer writer) {
    model::write_file(folder / file, [&](std::ostream& out) { writer(result, out); });
  };
  within_memory([&] {
    model::write_file(folder / "report.html",
                      [&](std::ostream& out) { reports::write_html(result, out, threads); });
    write("junit.xml", reports::write_junit);
    write("findings.sarif", reports::write_sarif);
    write("findings.csv", reports::write_findings_csv);
    reports::write_stages_vtm(result, folder);
    // Last: what looks for a finished run looks for this file.
    write("result.json", reports::write_result_json);
  });
}

}  // namespace limitgauge::app
