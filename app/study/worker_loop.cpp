#include "app/study/worker_loop.h"

#include <sys/prctl.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

#include "app/cli/error_message.h"
#include "app/study/study_cases.h"
#include "model/base/clock.h"
#include "model/base/error.h"
#include "model/base/memory.h"

namespace limitgauge::app {
namespace {

using study::WorkerAnswer;
using study::WorkerTask;
using RunTask = std::function<void(const WorkerTask&)>;

/// Interrupted is no answer: whoever stops a worker does not wait for one.
WorkerAnswer answer_of(const WorkerTask& task, const RunTask& run) {
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

void work_off_stream(std::istream& in, std::ostream& out, const RunTask& run,
                     const Console& console) {
  for (std::string line; std::getline(in, line);) {
    if (*console.stop) throw model::Interrupted();
    const std::optional<WorkerTask> task = study::task_of_line(line);
    if (task) out << to_line(answer_of(*task, run)) << std::flush;
  }
}

void work_off_file(const std::filesystem::path& file, const RunTask& run, const Console& console) {
  std::ifstream in(file);
  if (!in) throw model::ResourceError(file.string() + ": error: cannot read the tasks");
  // A task that Slurm starts again goes on where the first one was: what it answered stands, and
  // a line that it could not finish is closed.
  std::filesystem::path answers = file;
  std::ofstream out(answers.replace_extension(".out"), std::ios::app);
  out << '\n';
  work_off_stream(in, out, run, console);
  if (!out) throw model::ResourceError(answers.string() + ": error: cannot write the file");
}

}  // namespace

ExitCode work_off(const std::string& source, const RunTask& run, const Console& console) {
  try {
    if (source == "-") {
      // Who asked may be killed: nobody waits for the answer then.
      ::prctl(PR_SET_PDEATHSIG, SIGTERM);
      work_off_stream(std::cin, std::cout, run, console);
    } else {
      work_off_file(source, run, console);
    }
  } catch (const model::Interrupted&) {
    return ExitCode::resources;  // Whoever stopped it says so.
  }
  return ExitCode::pass;
}

}  // namespace limitgauge::app
