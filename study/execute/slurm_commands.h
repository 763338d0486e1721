#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limitgauge::study {

/// One task of a job array that Slurm has in its queue.
struct QueuedTask {
  std::string job;  ///< of the array
  std::size_t number = 0;
  bool started = false;
};

/// What is asked of Slurm, one program call each.
class SlurmCommands {
 public:
  /// `name` is that of all jobs. Throws model::InputError where Slurm's programs are missing,
  /// ResourceError where its controller does not answer.
  SlurmCommands(std::string name, std::vector<std::string> options,
                std::filesystem::path working_directory);

  /// Largest number of tasks of one array.
  std::size_t most_tasks() const { return most_tasks_; }
  /// Submits tasks 0 to `tasks` - 1, `running` of them at a time; gives the job's number. Throws
  /// model::ResourceError with Slurm's words where it is refused.
  std::string submit(const std::filesystem::path& script, std::size_t tasks,
                     std::size_t running) const;
  /// All tasks that wait or run; nothing where the controller does not answer (`why` says it).
  std::optional<std::vector<QueuedTask>> queue(std::string& why) const;
  void let_run(const std::string& job, std::size_t running) const;
  /// All jobs of this name.
  void cancel() const;
  /// How Slurm says that a task ended: "NODE_FAIL", "FAILED, signal 9"; empty where it does not.
  std::string ending(const std::string& job, std::size_t number) const;

 private:
  std::string name_;
  std::vector<std::string> options_;
  std::filesystem::path working_directory_;
  std::size_t most_tasks_ = 0;
};

/// The lines of `squeue --array --format="%F %K %T"`.
std::vector<QueuedTask> tasks_of_queue(const std::string& printed);
/// A value of what `scontrol show` prints: `KEY=VALUE` among blanks, or `KEY = VALUE` in a line.
std::string value_of(const std::string& printed, const std::string& key);

}  // namespace limitgauge::study
