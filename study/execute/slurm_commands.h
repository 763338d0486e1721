#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/execute/spawn.h"

namespace limitgauge::study {

/// One task of a job array that Slurm has in its queue.
struct QueuedTask {
  std::string job;  ///< of the array
  std::size_t number = 0;
  bool started = false;
  std::string state;        ///< as squeue calls it: PENDING, RUNNING, COMPLETING
  std::string node;         ///< that runs its script; empty where none does
  std::string partition;    ///< "short,long" of one that may go to either
  std::string reason;       ///< of one that is pending; may have blanks in it
  bool ran_before = false;  ///< known to whoever has looked before
};

/// What Slurm says of one node in one of its partitions.
struct NodeState {
  std::string partition, partition_state;  ///< up, down, drain, inact
  std::string name, state;                 ///< idle, allocated, down*: as sinfo's %T
};

/// What is asked of Slurm, one program call each.
class SlurmCommands {
 public:
  /// `name` is that of all jobs. Once `stop` is set (null: never), nothing is waited for any more,
  /// cancel() apart. Throws model::InputError where Slurm's programs are missing, ResourceError
  /// where its controller does not answer, Interrupted.
  SlurmCommands(std::string name, std::vector<std::string> options,
                std::filesystem::path working_directory, const std::atomic<bool>* stop);

  /// Another to be heeded.
  void heed(const std::atomic<bool>* stop) { patience_.stop = stop; }

  /// Largest number of tasks of one array.
  std::size_t most_tasks() const { return most_tasks_; }
  /// Submits tasks 0 to `tasks` - 1, `running` of them at a time; gives the job's number. Throws
  /// model::ResourceError with Slurm's words where it is refused.
  std::string submit(const std::filesystem::path& script, std::size_t tasks,
                     std::size_t running) const;
  /// All tasks that wait or run; nothing where the controller does not answer (`why` says it).
  std::optional<std::vector<QueuedTask>> queue(std::string& why) const {
    return queue(name_, why, patience_);
  }
  /// Waits until tasks that were told to end are gone from the queue, as long as `longest`: they
  /// write to their folder until then. False where some are still there.
  bool wait_for_cancelled(const std::string& name, std::chrono::milliseconds longest) const;
  /// All nodes of those partitions; none where they are not to be learnt.
  std::vector<NodeState> nodes(const std::vector<std::string>& partitions) const;
  void let_run(const std::string& job, std::size_t running) const;
  /// All jobs of a name; false where Slurm does not, or not at once.
  bool cancel(const std::string& name) const;
  /// Single tasks, "JOB_NUMBER".
  void cancel_tasks(const std::vector<std::string>& tasks) const;
  /// How Slurm says that a task ended: "NODE_FAIL", "FAILED, signal 9"; empty where it does not.
  std::string ending(const std::string& job, std::size_t number) const;

 private:
  std::optional<std::vector<QueuedTask>> queue(const std::string& name, std::string& why,
                                               const ProgramPatience& patience) const;

  std::string name_;
  std::vector<std::string> options_;
  std::filesystem::path working_directory_;
  std::size_t most_tasks_ = 0;
  ProgramPatience patience_;
};

/// The lines of `squeue --array --format="%F %K %T|%B|%P|%r"`; what follows the state may be
/// missing.
std::vector<QueuedTask> tasks_of_queue(const std::string& printed);
/// The lines of `sinfo --Node --format="%R|%a|%N|%T"`.
std::vector<NodeState> nodes_of_list(const std::string& printed);
/// A value of what `scontrol show` prints: `KEY=VALUE` among blanks, or `KEY = VALUE` in a line.
std::string value_of(const std::string& printed, const std::string& key);

}  // namespace limitgauge::study
