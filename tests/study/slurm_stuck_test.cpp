#include "study/execute/slurm_stuck.h"

#include "tests/support/catch.h"

namespace limitgauge::study {
namespace {

using std::chrono::minutes;

/// Looks at the same line of the queue and the same nodes once a minute; whether the task is given
/// up after `time`, with a patience of 8 minutes.
std::optional<std::string> verdict(const std::string& line, const std::string& nodes,
                                   minutes time = minutes(9), bool ran_before = false) {
  StuckTasks stuck(minutes(8));
  std::vector<QueuedTask> queue = tasks_of_queue(line);
  for (QueuedTask& task : queue) task.ran_before = ran_before;
  for (minutes at{0}; at <= time; ++at)
    stuck.see(queue, nodes_of_list(nodes), StuckTasks::Clock::time_point(at));
  return stuck.why(queue.at(0));
}

constexpr const char* kGood = "long|up|n1|idle\nlong|up|n2|mixed\n";
constexpr const char* kDead = "long|up|n1|down*\nlong|up|n2|drained\n";

TEST_CASE("what Slurm says of tasks and nodes is read", "[unit][study]") {
  const auto tasks = tasks_of_queue(
      "12 7 PENDING|n/a|short,long|Nodes required for job are DOWN | or so\n13 1 "
      "RUNNING|n1|long|None\n");
  REQUIRE(tasks.size() == 2);
  CHECK(tasks[0].node.empty());
  CHECK(tasks[0].partition == "short,long");
  CHECK(tasks[0].reason == "Nodes required for job are DOWN | or so");
  CHECK(tasks[1].node == "n1");
  CHECK(tasks[1].state == "RUNNING");
  const auto nodes = nodes_of_list("long|up|n1|down*\nnonsense\n");
  REQUIRE(nodes.size() == 1);
  CHECK(nodes[0].state == "down*");
}

TEST_CASE("a task whose node does not let go of it does not come back", "[unit][study]") {
  for (const char* state : {"COMPLETING", "NODE_FAIL", "REQUEUE_HOLD", "REQUEUED"}) {
    CAPTURE(state);
    const std::string line = "1 0 " + std::string(state) + "|n1|long|None\n";
    CHECK(verdict(line, kGood) == std::string(state) + " on node n1");
    CHECK_FALSE(verdict(line, kGood, minutes(7)));
  }
}

TEST_CASE("a task on a node that is down or silent does not come back", "[unit][study]") {
  for (const char* state :
       {"down", "down*", "mixed*", "allocated*", "unknown", "idle*", "drained*"}) {
    CAPTURE(state);
    const std::string nodes = "long|up|n1|" + std::string(state) + "\nlong|up|n2|idle\n";
    CHECK(verdict("1 0 RUNNING|n1|long|None\n", nodes) ==
          "RUNNING on node n1, which is " + std::string(state));
    CHECK_FALSE(verdict("1 0 RUNNING|n1|long|None\n", nodes, minutes(7)));
    CHECK_FALSE(verdict("1 0 RUNNING|n2|long|None\n", nodes));
  }
}

TEST_CASE("a task on a node that responds may take for ever", "[unit][study]") {
  for (const char* state : {"allocated", "mixed", "draining", "drained", "completing", "maint"}) {
    CAPTURE(state);
    const std::string nodes = "long|up|n1|" + std::string(state) + "\n";
    CHECK_FALSE(verdict("1 0 RUNNING|n1|long|None\n", nodes, minutes(5000)));
    CHECK_FALSE(verdict("1 0 SUSPENDED|n1|long|None\n", nodes, minutes(5000)));
  }
  // Nothing is known of its node.
  CHECK_FALSE(verdict("1 0 RUNNING|n1|long|None\n", "", minutes(5000)));
  CHECK_FALSE(verdict("1 0 RUNNING|n9|long|None\n", kDead, minutes(5000)));
}

TEST_CASE("a task that waits its turn is never given up", "[unit][study]") {
  for (const char* reason :
       {"Resources", "Priority", "JobArrayTaskLimit", "None", "QOSMaxCpuPerUserLimit", "BeginTime",
        "Dependency", "JobHeldUser", "AssocGrpCpuLimit", "Licenses", "Reservation",
        "ReqNodeNotAvail, UnavailableNodes:n2"}) {
    CAPTURE(reason);
    CHECK_FALSE(verdict("1 0 PENDING||long|" + std::string(reason), kGood, minutes(5000)));
  }
  // Even where no node is left, for a reason that does not speak of nodes.
  CHECK_FALSE(verdict("1 0 PENDING||long|Priority", kDead, minutes(5000)));
  CHECK_FALSE(verdict("1 0 PENDING||long|Resources", kDead, minutes(5000)));
}

TEST_CASE("a task that cannot start does not come back", "[unit][study]") {
  for (const char* reason : {"PartitionDown", "PartitionInactive", "JobHeldAdmin",
                             "launch failed requeued held", "BadConstraints"}) {
    CAPTURE(reason);
    CHECK(verdict("1 0 PENDING||long|" + std::string(reason), kGood) ==
          "pending: " + std::string(reason));
    CHECK_FALSE(verdict("1 0 PENDING||long|" + std::string(reason), kGood, minutes(7)));
  }
  CHECK(verdict("1 0 PENDING||long|BeginTime", kGood, minutes(9), true) == "pending: BeginTime");
  const std::string nodes_required =
      "1 0 PENDING||long|Nodes required for job are DOWN, DRAINED or reserved for jobs in higher "
      "priority partitions\n";
  REQUIRE(verdict(nodes_required, kDead));
  CHECK_THAT(*verdict(nodes_required, kDead), ContainsSubstring("no node of partition long"));
  CHECK(verdict(nodes_required, "long|down|n1|idle\n"));
  // Reserved for others, then.
  CHECK_FALSE(verdict(nodes_required, kGood, minutes(5000)));
  CHECK_FALSE(verdict(nodes_required, "", minutes(5000)));
  // What waits behind it.
  CHECK(verdict("1 1 PENDING||long|JobArrayTaskLimit\n" + nodes_required, kDead));
  CHECK_FALSE(verdict("1 1 PENDING||short|Priority\n" + nodes_required, kDead, minutes(5000)));
  CHECK_FALSE(verdict("1 0 PENDING||long,short|ReqNodeNotAvail", kDead, minutes(5000)));
}

TEST_CASE("what comes back in between begins anew", "[unit][study]") {
  StuckTasks stuck(minutes(8));
  const auto bad = tasks_of_queue("1 0 COMPLETING|n1|long|None\n2 0 RUNNING|n1|long|None\n");
  const auto good = tasks_of_queue("1 0 RUNNING|n1|long|None\n2 0 RUNNING|n1|long|None\n");
  for (minutes at{0}; at < minutes(40); ++at) {
    const bool back = at.count() % 7 == 6;
    stuck.see(back ? good : bad, nodes_of_list(back ? kGood : kDead),
              StuckTasks::Clock::time_point(at));
    CHECK_FALSE(stuck.why(bad[0]));
    CHECK_FALSE(stuck.why(bad[1]));
  }
}

}  // namespace
}  // namespace limitgauge::study
