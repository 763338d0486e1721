#include "app/study/study_worker.h"

#include <sys/prctl.h>

#include <csignal>
#include <fstream>
#include <iostream>
#include <new>

#include "app/cli/error_message.h"
#include "app/study/case_keys.h"
#include "app/study/case_runner.h"
#include "app/study/study_cases.h"
#include "model/base/clock.h"
#include "model/base/error.h"
#include "model/base/memory.h"
#include "study/execute/worker_lines.h"
#include "study/store/store.h"

namespace limitgauge::app {
namespace {

using study::WorkerAnswer;
using study::WorkerTask;

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

  WorkerAnswer answer(const WorkerTask& task);

 private:
  void run(const WorkerTask& task);

  std::filesystem::path job_;
  study::Store store_;
  CaseKeyMaker keys_;
  CaseRunner runner_;
};

void StudyWorker::run(const WorkerTask& task) {
  // Another study may have come by it in the meantime.
  if (store_.get("result", task.key)) return;
  if (keys_.keys(job_, task.overrides).result != task.key) {
    throw std::runtime_error(
        "the job, a file that it names or the program has changed since the study began");
  }
  store_.put("result", task.key, runner_.run(job_, task.overrides));
}

/// Interrupted is no answer: whoever stops a worker does not wait for one.
WorkerAnswer StudyWorker::answer(const WorkerTask& task) {
  WorkerAnswer answer;
  answer.index = task.index;
  model::reset_process_peak();
  const model::Stopwatch watch;
  const auto failed = [&](WorkerAnswer::Kind kind, const std::string& why) {
    answer.kind = kind;
    answer.reason = single_line(why);
  };
  try {
    run(task);
  } catch (const model::Interrupted&) {
    throw;
  } catch (const model::ResourceError& error) {
    failed(WorkerAnswer::Kind::again, error.what());
  } catch (const std::bad_alloc&) {
    failed(WorkerAnswer::Kind::again, "out of memory");
  } catch (const std::exception& error) {
    failed(WorkerAnswer::Kind::error, message_of(error));
  }
  answer.seconds = watch.seconds();
  answer.peak_bytes = model::process_peak_bytes();
  return answer;
}

void work_off(std::istream& in, std::ostream& out, StudyWorker& worker, const Console& console) {
  for (std::string line; std::getline(in, line);) {
    if (*console.stop) throw model::Interrupted();
    const std::optional<WorkerTask> task = study::task_of_line(line);
    if (task) out << to_line(worker.answer(*task)) << std::flush;
  }
}

void work_off_file(const std::filesystem::path& file, StudyWorker& worker, const Console& console) {
  std::ifstream in(file);
  if (!in) throw model::ResourceError(file.string() + ": error: cannot read the tasks");
  // A task that Slurm starts again goes on where the first one was: what it answered stands, and
  // a line that it could not finish is closed.
  std::filesystem::path answers = file;
  std::ofstream out(answers.replace_extension(".out"), std::ios::app);
  out << '\n';
  work_off(in, out, worker, console);
  if (!out) throw model::ResourceError(answers.string() + ": error: cannot write the file");
}

}  // namespace

ExitCode run_study_worker(const StudyCommand& command, const CommonOptions& common,
                          const Console& console) {
  StudyWorker worker(command, common, console);
  try {
    if (command.worker == "-") {
      // Who asked may be killed: nobody waits for the answer then.
      ::prctl(PR_SET_PDEATHSIG, SIGTERM);
      work_off(std::cin, std::cout, worker, console);
    } else {
      work_off_file(command.worker, worker, console);
    }
  } catch (const model::Interrupted&) {
    return ExitCode::resources;  // Whoever stopped it says so.
  }
  return ExitCode::pass;
}

}  // namespace limitgauge::app
