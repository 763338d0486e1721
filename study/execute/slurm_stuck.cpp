#include "study/execute/slurm_stuck.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace limitgauge::study {
namespace {

template <std::size_t count>
bool is_one_of(std::string_view word, const std::array<std::string_view, count>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// States in which a task has its nodes and is not over.
constexpr std::array<std::string_view, 7> kAtWork = {
    "RUNNING", "CONFIGURING", "SUSPENDED", "STOPPED", "RESIZING", "STAGE_OUT", "SIGNALING"};

/// Reasons of a pending task that somebody has to do something about. Its own user's (a hold, a
/// dependency, a time to begin at) are none of them, nor limits that others' jobs fill.
constexpr std::array<std::string_view, 12> kLastingReasons = {"PartitionDown",
                                                              "PartitionInactive",
                                                              "PartitionNodeLimit",
                                                              "PartitionTimeLimit",
                                                              "BadConstraints",
                                                              "InvalidAccount",
                                                              "InvalidQOS",
                                                              "JobHeldAdmin",
                                                              "FrontEndDown",
                                                              "JobHoldMaxRequeue",
                                                              "DependencyNeverSatisfied",
                                                              "AccountNotAllowed"};

/// What a task has that waits behind others of its partition.
constexpr std::array<std::string_view, 4> kBehindOthers = {"Priority", "Resources", "None",
                                                           "JobArrayTaskLimit"};

bool lasts(const QueuedTask& task) {
  // After a launch that failed: "launch failed requeued held".
  return is_one_of(task.reason, kLastingReasons) ||
         task.reason.find("requeued held") != std::string::npos;
}

bool names_nodes(const QueuedTask& task) {
  return task.reason.starts_with("ReqNodeNotAvail") || task.reason.starts_with("Nodes required") ||
         task.reason == "NodeDown";
}

/// Whether a state says that it should pass soon by itself.
bool should_pass(const QueuedTask& task) {
  if (task.state != "PENDING") return !is_one_of(task.state, kAtWork);
  return lasts(task) || (task.ran_before && task.reason == "BeginTime");
}

/// Without the marks that follow it: `down*`, `idle~`.
std::string_view bare_state(std::string_view state) {
  const std::size_t end = state.find_last_of("abcdefghijklmnopqrstuvwxyz_");
  return end == state.npos ? state : state.substr(0, end + 1);
}

bool is_dead(const NodeState& node) {
  constexpr std::array<std::string_view, 5> kDead = {"down", "unknown", "no_respond", "noresp",
                                                     "error"};
  return node.state.find('*') != std::string::npos || is_one_of(bare_state(node.state), kDead);
}

bool takes_nothing(const NodeState& node) {
  constexpr std::array<std::string_view, 7> kClosed = {"drained", "draining", "drain", "fail",
                                                       "failing", "inval",    "future"};
  return is_dead(node) || node.partition_state != "up" ||
         is_one_of(bare_state(node.state), kClosed);
}

std::string key_of(const QueuedTask& task) {
  return task.job + "_" + std::to_string(task.number);
}

}  // namespace

void StuckTasks::see(const std::vector<QueuedTask>& queue, const std::vector<NodeState>& nodes,
                     Clock::time_point now) {
  now_ = now;
  if (!nodes.empty()) see_nodes(nodes);
  std::set<std::string> there;
  blocked_partitions_.clear();
  for (const QueuedTask& task : queue) {
    there.insert(key_of(task));
    see_task(task);
  }
  std::erase_if(tasks_, [&](const auto& one) { return there.count(one.first) == 0; });
}

void StuckTasks::see_nodes(const std::vector<NodeState>& nodes) {
  std::map<std::string, std::string> dead;
  std::set<std::string> closed, open;
  for (const NodeState& node : nodes) {
    if (is_dead(node)) dead[node.name] = node.state;
    (takes_nothing(node) ? closed : open).insert(node.partition);
  }
  std::erase_if(dead_nodes_, [&](const auto& one) { return dead.count(one.first) == 0; });
  for (const auto& [name, state] : dead)
    dead_nodes_.try_emplace(name, Since{now_, state}).first->second.state = state;
  for (const std::string& one : open) dead_partitions_.erase(one);
  for (const std::string& one : closed)
    if (open.count(one) == 0) dead_partitions_.try_emplace(one, Since{now_, {}});
}

void StuckTasks::see_task(const QueuedTask& task) {
  const std::string state = task.state == "PENDING" ? task.reason : task.state;
  const std::string key = key_of(task);
  if (!should_pass(task)) {
    tasks_.erase(key);
  } else {
    Since& since = tasks_.try_emplace(key, Since{now_, state}).first->second;
    if (since.state != state) since = {now_, state};
  }
  if (task.state == "PENDING" && names_nodes(task)) blocked_partitions_.insert(task.partition);
}

std::optional<std::string> StuckTasks::why(const QueuedTask& task) const {
  const auto since = tasks_.find(key_of(task));
  const bool stays = since != tasks_.end() && is_over(since->second);
  if (task.state == "PENDING") return stays ? "pending: " + task.reason : why_pending(task);
  if (stays) return task.state + (task.node.empty() ? "" : " on node " + task.node);
  const auto node = dead_nodes_.find(task.node);
  if (node == dead_nodes_.end() || !is_over(node->second) || !is_one_of(task.state, kAtWork))
    return std::nullopt;
  return task.state + " on node " + task.node + ", which is " + node->second.state;
}

std::optional<std::string> StuckTasks::why_pending(const QueuedTask& task) const {
  const bool behind =
      is_one_of(task.reason, kBehindOthers) && blocked_partitions_.count(task.partition) > 0;
  if ((!names_nodes(task) && !behind) || !waits_for_dead_partition(task)) return std::nullopt;
  return "pending: no node of partition " + task.partition + " can take it (" + task.reason + ")";
}

/// All of them, where it may go to one of several: "short,long".
bool StuckTasks::waits_for_dead_partition(const QueuedTask& task) const {
  std::string_view rest = task.partition;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const auto found = dead_partitions_.find(std::string(rest.substr(0, comma)));
    if (found == dead_partitions_.end() || !is_over(found->second)) return false;
    rest.remove_prefix(comma == rest.npos ? rest.size() : comma + 1);
  }
  return !task.partition.empty();
}

}  // namespace limitgauge::study
