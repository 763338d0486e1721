#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/execute/executor.h"
#include "study/store/store.h"

namespace limitgauge::study {

struct SlurmOptions {
  std::vector<std::string> worker;  ///< the command of a worker, without tasks and threads
  /// For scripts, answers and logs, on a file system that the nodes share; made here, and removed
  /// where every case came to a result.
  std::filesystem::path folder;
  std::filesystem::path working_directory;
  std::string name;           ///< of the jobs, that no other job has: "limitgauge-0123abcd"
  std::size_t running = 100;  ///< tasks at a time
  unsigned retries = 2;
  std::vector<std::string> options;  ///< for sbatch
  /// How long answers of a task that has ended may take to be seen across the file system.
  std::chrono::milliseconds patience{5000};
  /// How long a task may not come back (see StuckTasks) before it is given up. Slurm itself takes
  /// up to 100 s to see that a node does not respond: together they are less than ten minutes.
  std::chrono::milliseconds stuck_patience = std::chrono::minutes(8);
  const std::atomic<bool>* stop = nullptr;  ///< while it is made; run() has one of its own
  std::function<void(const std::string&)> note = [](const std::string&) {};
};

/// Runs cases as job arrays of Slurm: tasks put results into the store, which the nodes share.
/// Tasks that do not come back are cancelled and their cases lost, at once: another try would wait
/// as long again. Jobs of studies that were killed, beside this one's folder, are cancelled first.
class Slurm : public Executor {
 public:
  /// Throws model::InputError where this machine has no Slurm, ResourceError where it does not
  /// answer, Interrupted.
  Slurm(SlurmOptions options, const Store& store);
  ~Slurm() override;
  void run(const std::vector<CaseRequest>& requests, const ReportOutcome& report,
           const std::atomic<bool>& stop) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace limitgauge::study
