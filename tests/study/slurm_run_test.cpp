#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "model/base/error.h"
#include "study/execute/slurm.h"
#include "study/execute/spawn.h"
#include "tests/study/fake_slurm.h"
#include "tests/support/catch.h"

namespace limitgauge::study {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

std::vector<CaseRequest> slurm_requests(std::size_t count) {
  std::vector<CaseRequest> requests(count);
  for (std::size_t i = 0; i < count; ++i)
    requests[i] = {i, std::string(63, 'a') + static_cast<char>('0' + i), {}, {}};
  return requests;
}

/// A study on the fake Slurm, whose patience is short.
struct Study {
  explicit Study(const FakeSlurm& slurm) : store(slurm.folder() / "cache", 1 << 30) {
    options.worker = {"worker"};
    options.name = "limitgauge-0123abcd";
    options.folder = folder();
    options.working_directory = slurm.folder();
    options.patience = milliseconds(100);
    options.stuck_patience = milliseconds(1500);
    options.note = [this](const std::string& line) { notes.push_back(line); };
  }
  fs::path folder() const { return store.folder() / "slurm" / options.name; }
  std::vector<CaseOutcome> run(std::size_t cases, milliseconds longest = milliseconds(30000)) {
    std::vector<CaseOutcome> outcomes;
    std::atomic<bool> stop = false;
    std::thread clock([&] {
      for (auto at = milliseconds(0); at < longest && !stop; at += milliseconds(20))
        std::this_thread::sleep_for(milliseconds(20));
      stop = true;
    });
    Slurm slurm(options, store);
    try {
      slurm.run(
          slurm_requests(cases), [&](const CaseOutcome& one) { outcomes.push_back(one); }, stop);
    } catch (const model::Interrupted&) {
      interrupted = true;
    }
    stop = true;
    clock.join();
    return outcomes;
  }

  Store store;
  SlurmOptions options;
  std::vector<std::string> notes;
  bool interrupted = false;
};

TEST_CASE("tasks on a node that does not come back are cancelled and their cases lost",
          "[unit][study]") {
  const FakeSlurm slurm;
  slurm.set_queue("1 0 RUNNING|n1|long|None\n1 1 COMPLETING|n2|long|None\n");
  slurm.set_nodes("long|up|n1|down*\nlong|up|n2|mixed\n");
  Study study(slurm);
  study.store.put("result", slurm_requests(3)[2].key, "here before its task died");
  const std::vector<CaseOutcome> outcomes = study.run(3);
  REQUIRE(outcomes.size() == 3);
  int lost = 0, done = 0;
  for (const CaseOutcome& one : outcomes) {
    lost += one.ending == CaseOutcome::Ending::lost ? 1 : 0;
    done += one.ending == CaseOutcome::Ending::done ? 1 : 0;
    CHECK(one.attempts == 1);
    if (one.ending == CaseOutcome::Ending::lost)
      CHECK_THAT(one.reason, ContainsSubstring("has not come back for 0.025 min (") &&
                                 ContainsSubstring(" on node n"));
  }
  CHECK(lost == 2);
  CHECK(done == 1);
  CHECK_FALSE(study.notes.empty());
  const auto cancelled = slurm.calls("scancel");
  CHECK(std::find(cancelled.begin(), cancelled.end(), "1_0 1_1") != cancelled.end());
  // Its log is kept, and nobody takes it for a study that was killed.
  CHECK(fs::exists(study.folder()));
  CHECK_FALSE(fs::exists(study.folder() / "submitter"));
}

TEST_CASE("tasks that cannot start are given up, tasks that wait their turn are not",
          "[unit][study]") {
  const FakeSlurm slurm;
  slurm.set_queue("1 0 PENDING||long|PartitionDown\n");
  slurm.set_nodes("long|down|n1|idle\n");
  Study study(slurm);
  const std::vector<CaseOutcome> outcomes = study.run(1);
  REQUIRE(outcomes.size() == 1);
  CHECK_THAT(outcomes[0].reason, ContainsSubstring("(pending: PartitionDown)"));

  const FakeSlurm busy;
  busy.set_queue("1 0 PENDING||long|Resources\n1 1 RUNNING|n1|long|None\n");
  busy.set_nodes("long|up|n1|allocated\n");
  Study patient(busy);
  patient.options.stuck_patience = milliseconds(200);
  CHECK(patient.run(2, milliseconds(2500)).empty());
  CHECK(patient.interrupted);
  CHECK_FALSE(fs::exists(patient.folder()));
}

/// A study in a process of its own that has submitted and waits, until it is killed.
pid_t start_waiting_study(const FakeSlurm& slurm, const std::string& name) {
  slurm.set_queue("1 0 PENDING||long|Resources\n");
  const std::size_t before = slurm.calls("sbatch").size();
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGTERM, SIG_DFL);
    Study study(slurm);
    study.options.name = name;
    study.options.folder = study.folder();
    study.run(1);
    ::_exit(0);
  }
  for (int i = 0; i < 500 && slurm.calls("sbatch").size() == before; ++i)
    std::this_thread::sleep_for(milliseconds(20));
  return child;
}

void kill_study(pid_t study) {
  ::kill(study, SIGKILL);
  ::waitpid(study, nullptr, 0);
}

bool was_cancelled(const FakeSlurm& slurm, const std::string& name) {
  const auto calls = slurm.calls("scancel");
  return std::find(calls.begin(), calls.end(), "--name=" + name) != calls.end();
}

TEST_CASE(
    "jobs of a study that was killed are cancelled by the next, those of a living one are not",
    "[unit][study]") {
  const FakeSlurm slurm;
  Study next(slurm);
  const fs::path others = next.store.folder() / "slurm";
  const pid_t living = start_waiting_study(slurm, "limitgauge-a11fe");
  const pid_t killed = start_waiting_study(slurm, "limitgauge-dead");
  REQUIRE(fs::exists(others / "limitgauge-dead/submitter"));
  kill_study(killed);
  // What was left of another kind, or has a name that is not ours, is left alone.
  fs::create_directories(others / "limitgauge-0ff");
  fs::create_directories(others / "somebody");
  std::ofstream(others / "somebody/submitter") << "x\n";
  next.store.put("result", std::string(64, 'e'), "of the killed one");
  slurm.set_queue("");
  { const Slurm study(next.options, next.store); }
  CHECK(was_cancelled(slurm, "limitgauge-dead"));
  CHECK(slurm.calls("scancel").size() == 1);
  CHECK_FALSE(fs::exists(others / "limitgauge-dead"));
  CHECK(fs::exists(others / "limitgauge-a11fe/submitter"));
  CHECK(fs::exists(others / "limitgauge-0ff"));
  CHECK(fs::exists(others / "somebody/submitter"));
  CHECK(next.store.has("result", std::string(64, 'e')));
  REQUIRE(next.notes.size() == 1);
  CHECK_THAT(next.notes[0], ContainsSubstring("limitgauge-dead"));
  kill_study(living);
}

TEST_CASE("a study of another machine is dead after half an hour without a sign", "[unit][study]") {
  const FakeSlurm slurm;
  Study next(slurm);
  const fs::path sign = next.store.folder() / "slurm/limitgauge-fa5/submitter";
  fs::create_directories(sign.parent_path());
  std::ofstream(sign) << "another machine's\n";
  const auto touched = [&](std::chrono::minutes ago) {
    fs::last_write_time(sign, fs::file_time_type::clock::now() - ago);
    const Slurm study(next.options, next.store);
  };
  touched(std::chrono::minutes(25));
  CHECK_FALSE(was_cancelled(slurm, "limitgauge-fa5"));
  CHECK(fs::exists(sign));
  touched(std::chrono::minutes(35));
  CHECK(was_cancelled(slurm, "limitgauge-fa5"));
  CHECK_FALSE(fs::exists(sign.parent_path()));
}

TEST_CASE("a study whose Slurm hangs is stopped all the same, and its jobs later",
          "[unit][study]") {
  const FakeSlurm slurm;
  slurm.set_queue("1 0 RUNNING|n1|long|None\n");
  slurm.hang("squeue");
  Study study(slurm);
  const auto began = std::chrono::steady_clock::now();
  CHECK(study.run(1, milliseconds(1000)).empty());
  // Within two seconds of being told to on an idle machine; squeue hangs for a hundred.
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(10));
  CHECK(study.interrupted);
  CHECK(was_cancelled(slurm, study.options.name));
  CHECK(fs::exists(study.folder() / "submitter"));
  const FakeSlurm again;
  Study next(slurm);
  next.options.name = "limitgauge-2";
  next.options.folder = next.folder();
  { const Slurm engine(next.options, next.store); }
  CHECK(was_cancelled(again, study.options.name));
  CHECK_FALSE(fs::exists(study.folder()));
}

TEST_CASE("a study whose Slurm hangs from the beginning is stopped", "[unit][study]") {
  const FakeSlurm slurm;
  slurm.hang("scontrol");
  Study study(slurm);
  const std::atomic<bool> stop = true;
  study.options.stop = &stop;
  CHECK_THROWS_AS(Slurm(study.options, study.store), model::Interrupted);
  CHECK_FALSE(fs::exists(study.folder()));
}

TEST_CASE("a program that does not come to its end is not waited for", "[unit][study]") {
  const auto began = std::chrono::steady_clock::now();
  const Printed printed = run_program({"/bin/sh", "-c", "echo word; sleep 60 & sleep 60"},
                                      {std::chrono::seconds(1), nullptr, false});
  CHECK(printed.exit_code == -SIGKILL);
  CHECK(printed.out == "word\n");
  CHECK_THAT(printed.errors, ContainsSubstring("did not come to its end in time"));
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(20));
}

}  // namespace
}  // namespace limitgauge::study
