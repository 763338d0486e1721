#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/error_message.h"
#include "app/cli/usage_error.h"
#include "app/inputs/mesh_target.h"
#include "app/job/job_reader.h"
#include "app/output/output_folder.h"
#include "app/output/progress.h"
#include "app/run/pipeline.h"
#include "app/run/run_history.h"
#include "app/share/piece_worker.h"
#include "app/share/shared_pieces.h"
#include "app/verify/verify_job.h"
#include "model/base/absolute_path.h"
#include "model/base/clock.h"
#include "model/base/error.h"
#include "model/base/memory.h"
#include "model/base/text_file.h"
#include "model/text/clean_text.h"
#include "reports/run/report.h"

namespace limitgauge::app {
namespace {

RunOptions options_for(const CommonOptions& common, const Console& console,
                       ProgressLine& progress) {
  RunOptions options;
  options.threads = common.threads;
  options.stop = console.stop;
  options.created = model::now_utc();
  options.watch.phase = [&progress](const Phase& phase) { progress.phase(phase); };
  options.watch.progress = [&progress](double fraction) { progress.update(fraction); };
  if (common.verbose) {
    options.watch.note = [&progress, &console](const std::string& line) {
      progress.clear();
      console.errors << line << std::endl;
    };
  }
  return options;
}

model::RunControl control_of(const RunOptions& options) {
  return {options.threads, options.stop, options.watch.progress};
}

ExitCode exit_code(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::pass:
      return ExitCode::pass;
    case verifier::Verdict::fail:
      return ExitCode::fail;
    default:
      return ExitCode::indeterminate;
  }
}

/// Does `work` in the folder; an error that is not the user's keeps what was finished.
template <class Work>
void work_in(OutputFolder& folder, const Work& work) {
  folder.prepare();
  try {
    work();
    folder.finish();
  } catch (const model::InputError&) {
    throw;
  } catch (const model::Interrupted&) {
    throw;
  } catch (const NotPublished&) {
    throw;
  } catch (const std::exception& error) {
    const std::string why = folder.named(message_of(error));
    const std::filesystem::path kept = folder.keep_incomplete(
        "This run did not come to its end: " + why +
        "\nStages with a deviation.vtp were finished; nothing else here is a result.");
    throw model::ResourceError(why + "\nlimitgauge: what was finished is kept in " + kept.string());
  }
}

void print_result(const reports::RunResult& result, const OutputFolder& folder,
                  const CommonOptions& common, const Console& console) {
  if (common.json) {
    // The bytes of the file, so that whoever reads either reads the same.
    console.out << model::read_text_file(folder.target() / "result.json") << std::flush;
    return;
  }
  if (common.quiet) return;
  console.out << reports::verdict_table(result, console.colour, console.out_columns)
              << "report: " << model::one_line((folder.target() / "report.html").string())
              << std::endl;
}

/// Calls `work(progress)` with a line of progress that is gone afterwards, whatever happens.
template <class Work>
void watched(const CommonOptions& common, const Console& console, const Work& work) {
  ProgressSurroundings around;
  around.columns = console.errors_columns;
  ProgressLine progress(console.errors, console.progress && !common.quiet, std::move(around));
  const ProgressTicker ticker(progress);
  progress.phase({"reading what the job names"});
  work(progress);
}

/// The run's id in its history; or why it is not in it.
struct Kept {
  std::optional<std::int64_t> id;
  std::string failure;
};

Kept kept_in(const RunHistory& history, const OutputFolder& folder) {
  if (!history.is_kept()) return {};
  try {
    return {history.add(folder.target()), {}};
  } catch (const model::ResourceError& error) {
    return {std::nullopt, error.what()};
  }
}

/// Everything is in its place before anything is printed: whoever should read it may be gone.
void print(const reports::RunResult& result, const OutputFolder& folder, const RunHistory& history,
           const CommonOptions& common, const Console& console) {
  const Kept kept = kept_in(history, folder);
  print_result(result, folder, common, console);
  if (!kept.failure.empty()) throw model::ResourceError(kept.failure);
  if (kept.id && !common.quiet && !common.json)
    console.out << "history: " << model::one_line(history.file().string()) << ", run " << *kept.id
                << std::endl;
}

/// A mesh taken for a cage is measured as another, smoother shape: whoever waits for the verdict is
/// told before the work begins.
void warn_of_mesh(const Job& job, const RunInputs& inputs, ProgressLine& progress,
                  const CommonOptions& common, const Console& console) {
  if (common.quiet || !inputs.design || inputs.design->mesh) return;
  const std::string warning = mesh_like_warning(summarize(inputs.design->cage));
  if (warning.empty()) return;
  progress.clear();
  console.errors << model::one_line(job.design->as_stated) << ": warning: " << warning << std::endl;
}

/// Makes of the options what a run shares its work by, once it is known how it is watched.
using ShareOut = std::function<std::unique_ptr<SharedPieces>(ProgressLine& progress)>;

ExitCode run_and_report(const Job& job, const std::filesystem::path& output,
                        const HistoryOptions& kept, const CommonOptions& common,
                        const Console& console, const ShareOut& share_out = {}) {
  reports::RunResult result;
  OutputFolder folder(output, common.force);
  const RunHistory history(kept, folder.target());
  watched(common, console, [&](ProgressLine& progress) {
    RunOptions options = options_for(common, console, progress);
    options.label = kept.label;
    const RunInputs inputs = load_inputs(job, {model::memory_limit_bytes()}, control_of(options));
    warn_of_mesh(job, inputs, progress, common, console);
    const auto shared = share_out ? share_out(progress) : nullptr;
    if (shared)
      options.share = [&](std::span<const model::Pass> passes) { return shared->of_stage(passes); };
    work_in(folder, [&] {
      result = run_job(job, inputs, folder.working(), options);
      progress.phase({"writing the report"});
      write_report(result, folder.working(), options.threads);
    });
  });
  print(result, folder, history, common, console);
  return exit_code(result.verdict);
}

std::filesystem::path or_default(const std::filesystem::path& stated, const std::string& name) {
  return stated.empty() ? std::filesystem::path("limitgauge-out") / name : stated;
}

}  // namespace

namespace {

/// Nothing that is stated is passed over in silence.
void check_engine(const EngineOptions& engine) {
  if (engine.engine == "slurm") return;
  if (engine.jobs > 0 || !engine.slurm_options.empty() || !engine.cache.empty())
    throw UsageError(
        "--jobs, --cache and --slurm-option say how work is shared out; "
        "expected "
        "--engine slurm beside them");
}

/// What is shared out is the measuring.
void require_shareable(const Job& job, const EngineOptions& engine) {
  if (engine.engine == "slurm" && !job.design)
    throw UsageError(
        "--engine slurm shares out what is measured against a surface, and the "
        "job has no [surface]; expected the run without it");
  if (engine.engine == "slurm" && has_setups(job))
    throw UsageError(
        "--engine slurm does not share out jobs with [[setup]]; expected the run without it");
}

ShareOut share_out(const RunCommand& command, const CommonOptions& common, const Console& console) {
  check_engine(command.engine);
  if (command.engine.engine != "slurm") return {};
  return [&](ProgressLine& progress) {
    SharedPiecesOptions options;
    options.engine = command.engine;
    options.job = model::absolute_path(command.job).lexically_normal();
    options.overrides = common.overrides;
    options.stop = console.stop;
    options.progress = [&progress](double fraction) { progress.update(fraction); };
    options.note = [&](const std::string& line) {
      if (common.quiet) return;
      progress.clear();
      console.errors << "limitgauge: " << line << std::endl;
    };
    return std::make_unique<SharedPieces>(std::move(options));
  };
}

}  // namespace

ExitCode execute(const RunCommand& command, const CommonOptions& common, const Console& console) {
  if (!command.engine.worker.empty()) return run_piece_worker(command, common, console);
  Job job = read_job(command.job, common.overrides);
  if (common.no_pictures) job.pictures = false;
  require_shareable(job, command.engine);
  return run_and_report(job, or_default(command.output, job.name), command.history, common, console,
                        share_out(command, common, console));
}

namespace {

/// Of `verify` and of `cut`: `job` is what their options make.
ExitCode run_program(Job job, const CutCommand& command, const CommonOptions& common,
                     const Console& console) {
  apply_verify_overrides(job, common.overrides);
  if (common.no_pictures) job.pictures = false;
  return run_and_report(job, or_default(command.output, job.name), command.history, common,
                        console);
}

}  // namespace

ExitCode execute(const VerifyCommand& command, const CommonOptions& common,
                 const Console& console) {
  return run_program(job_of(command), command, common, console);
}

ExitCode execute(const CutCommand& command, const CommonOptions& common, const Console& console) {
  return run_program(job_of(command), command, common, console);
}

ExitCode execute(const PlanCommand& command, const CommonOptions& common, const Console& console) {
  const Job job = read_job(command.job, common.overrides);
  OutputFolder folder(or_default(command.output, job.name + "-plan"), common.force);
  watched(common, console, [&](ProgressLine& progress) {
    const RunOptions options = options_for(common, console, progress);
    const RunInputs inputs = load_inputs(job, {model::memory_limit_bytes()}, control_of(options));
    work_in(folder, [&] { plan_job(job, inputs, folder.working(), options); });
  });
  if (!common.quiet)
    console.out << "toolpaths: " << model::one_line(folder.target().string()) << std::endl;
  return ExitCode::pass;
}

}  // namespace limitgauge::app
