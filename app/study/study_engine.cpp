#include "app/study/study_engine.h"

#include <algorithm>
#include <chrono>

#include "app/study/case_runner.h"
#include "model/base/error.h"
#include "model/base/memory.h"
#include "model/base/output_file.h"
#include "study/execute/local_pool.h"
#include "study/execute/slurm.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostKept = std::uint64_t{1} << 30;
constexpr std::uint64_t kKeptOfMemory = 4;  ///< all workers' stages together: a fourth of it
/// More patience than that is as much as for ever.
constexpr double kYear_min = 525600;

std::vector<std::string> worker_command(const fs::path& job, const study::Store& store) {
  return {"study", job.string(), "--quiet", "--cache", store.folder().string()};
}

void add(std::vector<std::string>& command, const std::string& option, const std::string& value) {
  command.push_back(option);
  command.push_back(value);
}

/// A case that cannot be forecast is one that cannot be run either: it is tried, and says why.
std::uint64_t forecast_of(CaseForecast& forecast, const fs::path& job,
                          const study::CaseRequest& request) {
  try {
    return forecast.bytes(job, request.overrides);
  } catch (const std::exception&) {
    return 0;
  }
}

std::unique_ptr<study::Executor> local_pool(const StudyCommand& command,
                                            const CommonOptions& common, const fs::path& job,
                                            const study::Store& store,
                                            const std::function<void(const std::string&)>& note,
                                            const std::atomic<bool>* stop) {
  study::LocalPoolOptions options;
  options.workers = command.jobs > 0 ? command.jobs : common.threads;
  options.retries = command.retries;
  options.memory_bytes = model::memory_limit_bytes();
  options.forecast_bytes =
      [job, forecast = std::make_shared<CaseForecast>(options.memory_bytes, stop)](
          const study::CaseRequest& request) { return forecast_of(*forecast, job, request); };
  options.note = note;
  // The file that runs, even where another has taken its name since.
  options.worker = worker_command(job, store);
  options.worker.insert(options.worker.begin(), "/proc/self/exe");
  add(options.worker, "--worker", "-");
  add(options.worker, "--threads", std::to_string(std::max(1U, common.threads / options.workers)));
  add(options.worker, "--worker-keeps",
      std::to_string(std::min(kMostKept, options.memory_bytes / kKeptOfMemory / options.workers)));
  // One limit for all: what is available to a worker depends on what the others do just then.
  add(options.worker, "--worker-memory", std::to_string(options.memory_bytes));
  return std::make_unique<study::LocalPool>(std::move(options));
}

/// No other study, on whatever machine, has it.
std::string unique_name() {
  return "limitgauge-" + model::random_digits();
}

}  // namespace

std::unique_ptr<study::Executor> slurm_engine(const EngineOptions& asked,
                                              const std::vector<std::string>& worker,
                                              const study::Store& store,
                                              const std::function<void(const std::string&)>& note,
                                              const std::atomic<bool>* stop) {
  study::SlurmOptions options;
  options.stop = stop;
  options.name = unique_name();
  options.folder = store.folder() / "slurm" / options.name;
  options.working_directory = model::absolute_path(".");
  if (asked.jobs > 0) options.running = asked.jobs;
  options.retries = asked.retries;
  options.options = asked.slurm_options;
  options.stuck_patience = std::chrono::ceil<std::chrono::milliseconds>(
      std::chrono::duration<double, std::ratio<60>>(std::min(asked.slurm_patience_min, kYear_min)));
  options.note = note;
  const fs::path program = fs::read_symlink("/proc/self/exe");
  if (!fs::exists(program))
    throw model::ResourceError(
        "limitgauge: error: its own file has been replaced since it was started; start it again");
  options.worker = {program.string()};
  options.worker.insert(options.worker.end(), worker.begin(), worker.end());
  return std::make_unique<study::Slurm>(std::move(options), store);
}

std::unique_ptr<study::Executor> study_engine(const StudyCommand& command,
                                              const CommonOptions& common, const fs::path& job,
                                              const study::Store& store,
                                              const std::function<void(const std::string&)>& note,
                                              const std::atomic<bool>* stop) {
  if (command.engine == "slurm") {
    std::vector<std::string> worker = worker_command(job, store);
    add(worker, "--worker-keeps", std::to_string(kMostKept));
    return slurm_engine(command, worker, store, note, stop);
  }
  return local_pool(command, common, job, store, note, stop);
}

}  // namespace limitgauge::app
