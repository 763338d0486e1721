#include "app/study/study_worker.h"

#include <stdexcept>

#include "app/study/case_keys.h"
#include "app/study/case_runner.h"
#include "app/study/worker_loop.h"
#include "model/base/clock.h"
#include "model/base/memory.h"
#include "study/store/store.h"

namespace limitgauge::app {
namespace {

RunOptions options_for(const CommonOptions& common, const Console& console) {
  RunOptions options;
  options.threads = common.threads;
  options.stop = console.stop;
  options.created = model::now_utc();
  return options;
}

class StudyWorker {
 public:
  StudyWorker(const StudyCommand& command, const CommonOptions& common, const Console& console)
      : job_(command.study),
        store_(command.cache, command.cache_limit_bytes),
        runner_(store_, options_for(common, console), command.worker_keeps_bytes,
                command.worker_memory_bytes > 0 ? command.worker_memory_bytes
                                                : model::memory_limit_bytes()) {}

  void run(const study::WorkerTask& task);

 private:
  std::filesystem::path job_;
  study::Store store_;
  CaseKeyMaker keys_;
  CaseRunner runner_;
};

void StudyWorker::run(const study::WorkerTask& task) {
  // Another study may have come by it in the meantime.
  if (store_.get("result", task.key)) return;
  if (keys_.keys(job_, task.overrides).result != task.key) {
    throw std::runtime_error(
        "the job, a file that it names or the program has changed since the study began");
  }
  store_.put("result", task.key, runner_.run(job_, task.overrides));
}

}  // namespace

ExitCode run_study_worker(const StudyCommand& command, const CommonOptions& common,
                          const Console& console) {
  StudyWorker worker(command, common, console);
  return work_off(
      command.worker, [&](const study::WorkerTask& task) { worker.run(task); }, console);
}

}  // namespace limitgauge::app
