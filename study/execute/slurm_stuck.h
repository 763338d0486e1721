#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/execute/slurm_commands.h"

namespace limitgauge::study {

/// Tasks that do not come back, told from those that merely take long or wait their turn.
///
/// A task does not come back where Slurm has said one of these for as long as the patience, without
/// saying anything else in between:
///
/// - its state is that of a task which is over (COMPLETING, NODE_FAIL, REQUEUE_HOLD and others),
/// and
///   it stays in the queue all the same: its node does not say that it has let go of it;
/// - it runs on a node that is down or does not respond (sinfo: down, unknown, a `*` at its end);
/// - it is pending for a reason that time does not change (kLastingReasons), or, having run before,
///   for its start to come (BeginTime), which Slurm sets two minutes ahead;
/// - it is pending because nodes are not available, and its partition has no node that could take
///   anything: all are down, drained, draining or failing, or the partition is not up. What is
///   pending behind such a task of the same partition (Priority, Resources) does not either.
///
/// So a task on a node that responds may take as long as it likes, and one that is pending for any
/// other reason (Resources, Priority, JobArrayTaskLimit, limits of a user) waits for ever. Where
/// Slurm says nothing of its nodes, no task is stuck because of them.
class StuckTasks {
 public:
  using Clock = std::chrono::steady_clock;
  explicit StuckTasks(std::chrono::milliseconds patience) : patience_(patience) {}

  /// One look. `nodes` are empty where they were not asked for, or did not answer: what is known of
  /// them stays.
  void see(const std::vector<QueuedTask>& queue, const std::vector<NodeState>& nodes,
           Clock::time_point now);
  /// Why a task that was seen in the last look does not come back; nothing where it may.
  std::optional<std::string> why(const QueuedTask& task) const;

 private:
  struct Since {
    Clock::time_point time;
    std::string state;
  };
  void see_nodes(const std::vector<NodeState>& nodes);
  void see_task(const QueuedTask& task);
  bool is_over(const Since& since) const { return now_ - since.time >= patience_; }
  std::optional<std::string> why_pending(const QueuedTask& task) const;
  bool waits_for_dead_partition(const QueuedTask& task) const;

  std::chrono::milliseconds patience_;
  Clock::time_point now_{};
  std::map<std::string, Since> tasks_;       ///< in a state that should pass, by job and number
  std::map<std::string, Since> dead_nodes_;  ///< by name
  std::map<std::string, Since> dead_partitions_;
  std::set<std::string> blocked_partitions_;  ///< with a task that waits for their nodes
};

}  // namespace limitgauge::study
