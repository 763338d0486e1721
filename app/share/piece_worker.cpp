#include "app/share/piece_worker.h"

#include <stdexcept>

#include "app/inputs/run_inputs.h"
#include "app/job/job_reader.h"
#include "app/run/stage_check.h"
#include "app/share/piece_store.h"
#include "app/study/case_keys.h"
#include "app/study/worker_loop.h"
#include "model/base/error.h"
#include "model/base/memory.h"
#include "study/store/store.h"

namespace limitgauge::app {
namespace {

/// What the store must have is on a file system that may be slow to show it.
std::string stored(const study::Store& store, const char* kind, const std::string& key) {
  auto content = store.get(kind, key);
  if (!content)
    throw model::ResourceError(store.folder().string() + ": error: no whole " + kind + " " + key +
                               " is there; expected a folder that all nodes share");
  return std::move(*content);
}

class PieceWorker {
 public:
  PieceWorker(const RunCommand& command, const CommonOptions& common, const Console& console)
      : file_(command.job),
        overrides_(common.overrides),
        job_(read_job(command.job, common.overrides)),
        inputs_(load_inputs(job_, {model::memory_limit_bytes()})),
        // After reading: what was read is what the key says.
        key_(case_keys(command.job, common.overrides).result),
        store_(command.engine.cache, command.engine.cache_limit_bytes),
        control_{common.threads, console.stop, {}} {}

  void run(const study::WorkerTask& asked) const;

 private:
  std::vector<model::Pass> passes_of(const SharedStage& shared) const;

  std::filesystem::path file_;
  std::vector<std::string> overrides_;
  Job job_;
  RunInputs inputs_;
  std::string key_;
  study::Store store_;
  model::RunControl control_;
};

std::vector<model::Pass> PieceWorker::passes_of(const SharedStage& shared) const {
  if (shared.job_key != key_ || shared.stage >= job_.stages.size())
    throw std::runtime_error(
        "the job, a file that it names or the program has changed since the run began");
  std::vector<model::Pass> passes;
  for (std::size_t i = 0; i < shared.paths.size(); ++i)
    passes.push_back({job_.stages[i].cutter, shared.paths[i], {}, false, shared.axes[i]});
  return passes;
}

void PieceWorker::run(const study::WorkerTask& asked) const {
  const auto task = piece_task_of(asked.overrides);
  if (!task || piece_key(*task) != asked.key) throw std::runtime_error("no piece of a stage");
  // Another try may have come to it.
  if (store_.get(kPieceKind, asked.key)) return;
  const auto shared = shared_stage_of(stored(store_, kStageKind, task->stage_key));
  if (!shared) throw std::runtime_error("no stage to be measured");
  const std::vector<model::Pass> passes = passes_of(*shared);
  const std::string reach =
      task->reach_key.empty() ? std::string() : stored(store_, kReachKind, task->reach_key);
  store_.put(kPieceKind, asked.key,
             do_piece(inputs_.design.value().surface, job_.stock, passes,
                      stage_check(job_, inputs_, shared->stage), task->piece, reach, control_));
}

}  // namespace

ExitCode run_piece_worker(const RunCommand& command, const CommonOptions& common,
                          const Console& console) {
  const PieceWorker worker(command, common, console);
  return work_off(
      command.engine.worker, [&](const study::WorkerTask& task) { worker.run(task); }, console);
}

}  // namespace limitgauge::app
